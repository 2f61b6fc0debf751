#pragma once
#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "dataflow/core/time/fifo_timing.hpp"

namespace dataflow::timing {

/// What a stream was delivered, from some moment on.
struct DeliveryTape {
    struct Delivery {
        std::uint64_t tokens = 0;
        Cycles cycle = 0;
    };
    std::vector<Delivery> deliveries;

    void add(Cycles cycle) {
        if (deliveries.empty() || deliveries.back().cycle != cycle)
            deliveries.push_back({0, cycle});
        ++deliveries.back().tokens;
    }
};

/// A process's end of the external memory. To the process it is a FIFO with the memory at the other end: tokens that it
/// reads in its steps, or results that it writes and never waits for. The memory learns from it when the process comes
/// to an entry, and when it takes a token.
class MemoryStream {
  public:
    /// How a process comes to an entry of the memory's.
    enum class EntersBy {
        loop,  ///< by entering a loop, each iteration of which takes a token
        step,  ///< by coming to a step, which takes one token
        write  ///< by a step that writes: in the cycle after it
    };

    MemoryStream(std::string const& name, EntersBy enters_by)
        : fifo_(FifoTiming::of_memory(name, enters_by == EntersBy::write)), enters_by_(enters_by) {}

    std::string const& name() const { return fifo_.name(); }
    EntersBy enters_by() const { return enters_by_; }
    bool is_write() const { return enters_by_ == EntersBy::write; }
    FifoTiming& fifo() { return fifo_; }
    FifoTiming const& fifo() const { return fifo_; }

    // The process.

    void enters_loop(Cycles cycle) { entered_.push_back(cycle); }
    /// Has come to a step, and may say so again while it waits.
    void comes_to_step(Cycles cycle) {
        if (enters_by_ == EntersBy::step && told_ == fifo_.reads()) {
            entered_.push_back(cycle);
            ++told_;
        }
    }

    // The memory.

    /// Cycles in which the process came to entries, in order, as far as nobody has taken them out.
    bool knows_entry() const { return is_write() ? fifo_.known_reads() > 0 : !entered_.empty(); }
    Cycles take_entry();

    /// The next tokens can be read from a cycle on.
    void deliver(std::uint64_t tokens, Cycles cycle) {
        deliver_each(tokens, [cycle] { return cycle; });
    }
    /// Each from its own: what `next()` gives, which never falls.
    template <class Next> void deliver_each(std::uint64_t tokens, Next next) {
        if (tokens == 0)
            return;
        for (DeliveryTape* const tape : tapes_) {
            Next again = next;
            for (std::uint64_t token = 0; token < tokens; ++token)
                tape->add(again());
        }
        fifo_.deliver(tokens, next);
        readable_ = fifo_.earliest_read(fifo_.known_reads() - 1);
    }
    /// Tokens that cost nothing, as the memory is ideal.
    void deliver_at_once(std::uint64_t tokens) {
        is_ideal_ = true;
        deliver(tokens, Cycles{0});
    }
    bool is_ideal() const { return is_ideal_; }
    void add_tape(DeliveryTape& tape) { tapes_.push_back(&tape); }
    void remove_tape(DeliveryTape& tape) {
        tapes_.erase(std::remove(tapes_.begin(), tapes_.end(), &tape), tapes_.end());
    }
    /// Stands where another stream does, and is at no memory: it has to be told what that one is delivered.
    void take_state(MemoryStream const& other) {
        fifo_ = other.fifo_;
        is_ideal_ = other.is_ideal_;
    }
    /// The next tokens need nothing.
    void deliver_free(std::uint64_t tokens) { deliver(tokens, readable_); }
    /// Tokens taken and not forgotten, and the cycle after the i-th of them was taken.
    std::uint64_t taken() const { return fifo_.known_writes(); }
    Cycles after_taking(std::uint64_t i) const { return fifo_.earliest_write(i); }
    void forget_taken(std::uint64_t tokens) { fifo_.forget_taken(tokens); }

  private:
    FifoTiming fifo_;
    EntersBy enters_by_;
    std::deque<Cycles> entered_;
    std::uint64_t told_ = 0;
    bool is_ideal_ = false;
    std::vector<DeliveryTape*> tapes_;
    Cycles readable_ = 0;  // from when on the last token delivered can be read
};

inline Cycles MemoryStream::take_entry() {
    if (is_write()) {
        Cycles const cycle = fifo_.earliest_read();
        fifo_.read(cycle);
        return cycle;
    }
    Cycles const cycle = entered_.front();
    entered_.pop_front();
    return cycle;
}

}  // namespace dataflow::timing
