#pragma once
#include <string>
#include <systemc>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/core/time/ports.hpp"
#include "dataflow/tools/recording/token_tap.hpp"

namespace dataflow {

class ProcessClock;

/// The part of a clocked FIFO that does not depend on its token type: its timing, its two ends and who waits for whom.
class FifoChannel : public sc_core::sc_prim_channel {
  public:
    FifoChannel(char const* name, timing::FifoTiming& timing) : sc_prim_channel(name), timing_(timing) {}
    char const* kind() const override { return "clocked_fifo"; }

    timing::FifoTiming& timing() { return timing_; }
    timing::FifoTiming const& timing() const { return timing_; }

    void connect_reader(ProcessClock& clock, unsigned port) {
        reader_ = &clock;
        read_port_ = timing::Ports::of(port);
    }
    void connect_writer(ProcessClock& clock, unsigned port) {
        writer_ = &clock;
        write_port_ = timing::Ports::of(port);
    }
    /// Modules with a port that is bound to it; from end_of_elaboration() on.
    std::vector<std::string> const& bound_modules() const { return bound_modules_; }
    /// A process has stopped for it.
    bool is_awaited() const { return reader_waits_ || writer_waits_; }
    /// What the FIFO's tokens consist of.
    virtual std::vector<TokenField> token_fields() const = 0;
    /// See all tokens that are appended from now on.
    std::vector<recording::TokenTap*>& taps() { return taps_; }

    /// The port of its reader (writer) at this FIFO. What is accessed together is put together by |.
    timing::Ports read_port() const { return read_port_; }
    timing::Ports write_port() const { return write_port_; }

  protected:
    friend class ProcessClock;
    void note_bound(sc_core::sc_port_base const& port) {
        if (sc_core::sc_object const* const module = port.get_parent_object(); module != nullptr)
            bound_modules_.emplace_back(module->basename());
    }
    void wake_reader() {
        if (reader_waits_) {
            reader_waits_ = false;
            written_.notify();
        }
    }
    void wake_writer() {
        if (writer_waits_) {
            writer_waits_ = false;
            read_.notify();
        }
    }

    /// Its writer, or its reader, is done with a call.
    virtual void end_call(bool /*of_writer*/) {}

    /// Of what asks for more than whether there is a token, or room for one.
    [[noreturn]] void refuse(char const* call) const {
        throw InputError(std::string(name()) + ": " + call +
                         " asks what a FIFO holds at the moment, which is not modelled, expected read_nb(), " +
                         "write_nb(), empty() or full()");
    }

    ProcessClock* reader_ = nullptr;
    ProcessClock* writer_ = nullptr;
    timing::Ports read_port_;
    timing::Ports write_port_;
    std::vector<recording::TokenTap*> taps_;
    sc_core::sc_event written_;
    sc_core::sc_event read_;

  private:
    timing::FifoTiming& timing_;
    std::vector<std::string> bound_modules_;
    bool reader_waits_ = false;
    bool writer_waits_ = false;
};

/// One that hands over calls, and no tokens: see with_calls().
class HandOverChannel final : public FifoChannel {
  public:
    using FifoChannel::FifoChannel;
    std::vector<TokenField> token_fields() const override { return {}; }
};

}  // namespace dataflow
