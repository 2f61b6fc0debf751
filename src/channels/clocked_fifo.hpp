#pragma once
#include <algorithm>
#include <systemc>

#include "channels/fifo_channel.hpp"
#include "channels/process_clock.hpp"
#include "channels/token_queue.hpp"

namespace dataflow {

/// A FIFO whose accesses take place in cycles (docs/timing-model.md#fifos). Modules use it through plain sc_fifo_in/out
/// ports; every read() or write() is then a step of the calling process, or part of its open Step. Loops whose every
/// iteration accesses the same move many tokens at once: tokens_of(), TokenLoop. What those do not say moves bursts
/// with peek/consume and reserve/commit, and tells its clock what it did.
///   order   first in, first out; one reader and one writer, both with a ProcessClock
///   time    kept by timing::FifoTiming; the tokens themselves may be in the host's hands earlier (decoupled)
///   width   a token may be several values side by side, its lanes; such tokens move in bursts only
///   fields  how many of a token's fields there are as wires, for recordings; the last may not be
///   choice  read_nb(), write_nb(), empty() and full() do not wait: what they find in the cycle of their step decides
///           (docs/timing-model.md#non-blocking-accesses). The end is described as non_blocking().
///   errors  InputError for num_available(), num_free() and SystemC's events of FIFOs: there are none
template <class Token>
class ClockedFifo : public FifoChannel, public sc_core::sc_fifo_in_if<Token>, public sc_core::sc_fifo_out_if<Token> {
  public:
    ClockedFifo(char const* name, timing::FifoTiming& timing, std::size_t lanes = 1,
                std::size_t fields = TokenFields<Token>::layout.size())
        : FifoChannel(name, timing), tokens_(lanes), host_limit_(host_limit(timing.shape())), fields_(fields) {}

    void register_port(sc_core::sc_port_base& port, char const* /*type*/) override { note_bound(port); }

    void read(Token& token) override { token = read(); }
    Token read() override {
        if (tokens_.size() == 0 || !reader_->reads_soundly(read_port_))
            await_and_access();
        Token const token = *tokens_.front();
        consume(1);
        return token;
    }
    /// Takes a token if there is one to be read in this cycle. As its name in sc_fifo_in_if.
    bool read_nb(Token& token) {
        if (!reader_->attempts(*this, read_port_))
            return false;
        token = take();
        return true;
    }
    bool nb_read(Token& token) override { return read_nb(token); }
    /// Whether there is none.
    bool empty() const { return !reader_->asks(*this, read_port_); }
    int num_available() const override { refuse("num_available"); }
    sc_core::sc_event const& data_written_event() const override { refuse("data_written_event"); }

    void write(Token const& token) override {
        if (tokens_.size() > host_limit_ || !writer_->accesses_soundly(write_port_)) {
            put_and_access(token);
            return;
        }
        *reserve(1) = token;
        commit(1);
    }
    /// Writes a token if there is room for it in this cycle. As its name in sc_fifo_out_if.
    bool write_nb(Token const& token) {
        if (!writer_->attempts(*this, write_port_))
            return false;
        put(token);
        return true;
    }
    bool nb_write(Token const& token) override { return write_nb(token); }
    /// Whether there is no room.
    bool full() const { return !writer_->asks(*this, write_port_); }
    int num_free() const override { refuse("num_free"); }
    sc_core::sc_event const& data_read_event() const override { refuse("data_read_event"); }

    /// The tokens at hand, contiguous from front(); suspends the reader until there is one. In lockstep it is one at a
    /// time. `others`: what has been found to be there, and is read in the same cycle.
    std::size_t peek(timing::Ports others = {}) {
        std::size_t there = visible();
        for (; there == 0; there = visible())
            reader_->wait_for_tokens(*this, others);
        return there;
    }
    /// The next token, as soon as the host has it, whatever its cycle: for loops that read in a later stage. The module
    /// tells its clock of iteration i, then of as many more as the stage is behind, and only then takes the token of
    /// iteration i, as the hardware does; the last ones after leave_loop(). A token that decides what is written in the
    /// very step in which it is read is taken, and the answer written, before the clock is told of that iteration.
    Token take() {
        while (tokens_.size() == 0)
            reader_->wait_for_tokens(*this);
        Token const token = *tokens_.front();
        consume(1);
        return token;
    }
    /// A token, whenever the host has it: the module tells its clock of the write on its own.
    void put(Token const& token) {
        await_room();
        *reserve(1) = token;
        commit(1);
    }
    Token const* front() const { return tokens_.front(); }
    void consume(std::size_t count) {
        tokens_.drop(count);
        if (tokens_.size() <= host_limit_ / 2)
            wake_writer();
    }

    /// Suspends the writer while the reader is far behind. A burst over several FIFOs awaits room in all of them before
    /// it reserves any: other processes run meanwhile.
    void await_room() {
        while (tokens_.size() > host_limit_)
            writer_->wait_for_room(*this);
    }
    /// Room for `count` tokens, valid until the next call. append() makes them part of the channel, wake_reader() tells
    /// the reader, if it waits for tokens; commit() does both.
    Token* reserve(std::size_t count) { return tokens_.room(count); }
    void append(std::size_t count) {
        tokens_.append(count);
        if (!taps_.empty())
            show(count);
    }
    void commit(std::size_t count) {
        append(count);
        wake_reader();
    }
    using FifoChannel::wake_reader;

    std::vector<TokenField> token_fields() const override {
        std::vector<TokenField> fields;
        for (std::size_t lane = 0; lane < tokens_.width(); ++lane)
            for (std::size_t i = 0; i < fields_; ++i) {
                TokenField field = TokenFields<Token>::layout[i];
                field.lane = tokens_.width() > 1 ? static_cast<int>(lane) : TokenField::only_lane;
                fields.push_back(field);
            }
        return fields;
    }

  private:
    [[gnu::noinline]] void await_and_access() {
        reader_->require_own(*this, false);
        reader_->begins_read(read_port_);
        peek();
        reader_->access(read_port_);
    }
    [[gnu::noinline]] void put_and_access(Token const& token) {
        writer_->require_own(*this, true);
        put(token);
        writer_->access(write_port_);
    }
    /// Shows the last `count` tokens to the taps.
    [[gnu::noinline]] void show(std::size_t count) {
        for (recording::TokenTap* tap : taps_) {
            std::int64_t* at = tap->room(count);
            for (Token const* token = tokens_.end() - count * tokens_.width(); token != tokens_.end(); ++token)
                for (std::size_t i = 0; i < fields_; ++i)
                    *at++ = TokenFields<Token>::values(*token)[i];
        }
    }
    /// Enough for what the modelled FIFO and the pipelines at its ends can hold, or the host would add stalls of its
    /// own.
    static std::size_t host_limit(timing::FifoShape const& shape) {
        return std::max<std::uint64_t>(1024, 2 * (shape.capacity + shape.write_latency + shape.read_stage) + 64);
    }
    std::size_t visible() const {
        return reader_->lockstep() ? std::min<std::size_t>(1, tokens_.size()) : tokens_.size();
    }

    TokenQueue<Token> tokens_;
    std::size_t host_limit_;
    std::size_t fields_;
};

}  // namespace dataflow
