#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/base/each_bit.hpp"
#include "dataflow/core/time/bulk_runs.hpp"
#include "dataflow/core/time/trail.hpp"
#include "dataflow/lookup/bench_fifo.hpp"
#include "dataflow/lookup/relative_state.hpp"
#include "dataflow/lookup/state_words.hpp"
#include "dataflow/phrases/group.hpp"

namespace dataflow::timing {

/// A port of a process on the bench.
struct BenchPort {
    using Line = BenchLine;

    FifoEnd<BenchLine> end;
    unsigned number = 0;
    unsigned other = 0;      ///< member at the other end
    std::uint32_t fifo = 0;  ///< of the group: its bit
    std::uint32_t* stalls = nullptr;
};

/// A process on the bench: does by ProcessRules what ProcessTiming does, at times relative to the driver's at the
/// begin. Knows its FIFOs in the group, and only what a phrase can say.
class BenchProcess : private BulkRuns<BenchProcess, BenchPort> {
  public:
    using Rules = BulkRuns<BenchProcess, BenchPort>;
    using Rules::finished;
    using Rules::flushes;
    using Rules::leave_trail;
    using Rules::log;
    using Rules::not_before;
    using Rules::plan;
    using Rules::sets_up_ahead;
    using Rules::state;
    static constexpr unsigned no_port = RelativeState::no_port;

    /// `figures` are those of its loops and setups, see RelativeState::blocks_of(), which grow.
    BenchProcess(ProcessTiming const& process, FigureBlock* figures, Trail* trail);
    void connect(BenchPort const& port) { ports_[port.number] = port; }

    /// Returns the words behind its own.
    StateWord const* load(StateWord const* words);
    /// A transition begins.
    void start() {
        iterations_before_ = state_.iterations;
        entered_ = has_awaited_ = false;
        counted_ = waited_ = 0;
    }
    /// Puts down its words.
    void save(StatePage& page);
    /// That it puts down.
    std::size_t most_words() const { return most_words_of<Rules>(*this, *shape_); }

    void append(Operation const& operation) { log_.append(operation); }
    /// Takes steps as long as it can. The FIFOs that it accessed, a bit each.
    std::uint32_t advance() {
        accessed_ = blocked_at_ = 0;
        go_on();
        log_.compact();
        return accessed_;
    }
    /// After advance(), if it is not finished: FIFOs that it cannot access, a bit each.
    std::uint32_t blocked_at() const { return blocked_at_; }

    std::int64_t time() const { return state_.time; }
    Ports::Number next_ports() const { return log_.exhausted() ? outlook_ports_ : log_.begin()->ports(); }
    BenchPort const& port(unsigned number) const { return ports_[number]; }
    bool is_known(unsigned number) const { return ports_[number].end.known() > 0; }
    /// Waits at a port until a cycle, if that is later.
    void wait(unsigned number, std::int64_t cycle) {
        if (cycle <= state_.time)
            return;
        charge(ports_[number], cycle - state_.time);
        state_.time = cycle;
    }

    // Of its flushing pipeline.

    bool holds_tokens() const { return !state_.flushing.is_empty(); }
    /// For a token, as far as is known.
    bool awaits_room() const { return state_.flushing.is_waiting(); }
    unsigned flushing_port() const { return shape_->flushing_port; }
    /// Takes in bubbles up to the cycle from which on a port can be read, or until it stands still: whether it does.
    bool idle_until(std::int64_t cycle, unsigned number) {
        auto const step = state_.flushing.step_from(state_.time, cycle);
        go_to(step, ports_[number]);
        return step.is_open;
    }

    bool is_frozen() const { return frozen_; }
    void set_outlook(Ports::Number next_ports, bool frozen) {
        outlook_ports_ = next_ports;
        frozen_ = frozen;
    }
    unsigned parked_at() const { return parked_at_; }
    void set_parked_at(unsigned port) { parked_at_ = port; }

    /// Visits the figures of its loops and setups that may have grown since start().
    template <class Visit> void each_figures(Visit visit) const {
        for_each_bit(counted_, [&](unsigned loop) {
            for (std::uint32_t i = 0; i < figures_[loop].blocks; ++i)
                visit(figures_[loop].first[i]);
        });
        if (has_awaited_)
            visit(*awaited_setups_);
    }
    /// FIFOs that it may have waited for since start(), besides those that it accessed, a bit each.
    std::uint32_t waited() const { return waited_; }
    bool has_entered() const { return entered_; }
    /// Iterations since start(), or since it entered the loop it is in, or left.
    std::uint64_t iterations() const { return state_.iterations - (entered_ ? 0 : iterations_before_); }

  private:
    friend ProcessRules<BenchProcess, BenchPort>;
    friend Rules;
    struct LoopFigures {
        FigureBlock* first;
        std::uint32_t blocks;
    };

    // What ProcessRules ask for.
    bool goes_by_steps() const { return false; }
    bool choose(Operation const& /*operation*/) const { return true; }  // no follower makes attempts
    bool may_go_on() const { return true; }
    std::int64_t first_call() const { return state_.time; }  // is over: everybody in the group has begun
    bool may_access(Ports::Number /*ports*/) const { return true; }
    void wait_for(BenchPort const& port) { blocked_at_ |= port.fifo; }
    void charge(BenchPort const& port, std::int64_t stall) {
        *port.stalls += static_cast<std::uint32_t>(stall);
        waited_ |= port.fifo;
    }
    void performs(Ports::Number /*ports*/, std::int64_t /*arrival*/) const {}
    void note(BenchPort const& port, std::uint64_t /*count*/) { accessed_ |= port.fifo; }
    void count(std::uint64_t iterations) {
        figures_[state_.loop].first->sums[1] += static_cast<std::uint32_t>(iterations);
        counted_ |= 1U << state_.loop;
    }
    void iterates(std::uint64_t /*first*/, std::uint64_t /*count*/) const {}
    void entered() { entered_ = true; }
    void entered_again() const {}
    void count_end();
    void left() const {}
    void awaited_setup(std::int64_t cycles) {
        awaited_setups_->sums[0] += static_cast<std::uint32_t>(cycles);
        has_awaited_ = true;
    }
    void awaited_write(Cycles cycles) {
        figures_[state_.loop].first->sums[2] += static_cast<std::uint32_t>(cycles);
        counted_ |= 1U << state_.loop;
    }
    void stamped() const {}  // in no phrase
    void let_bubbles_in(BenchPort const& port, std::int64_t bubbles, std::int64_t /*from*/) { charge(port, bubbles); }
    void lets_out(BenchPort const& port, std::int64_t due, std::int64_t cycle) {
        if (cycle > due)
            charge(port, cycle - due);
    }
    void waits_for_room(BenchPort const& port) { wait_for(port); }

    std::vector<BenchPort> ports_;
    std::vector<LoopFigures> figures_;  ///< by loop
    FigureBlock* awaited_setups_ = nullptr;
    bool has_awaited_ = false;
    std::uint64_t iterations_before_ = 0;
    bool entered_ = false;
    std::uint32_t counted_ = 0;   ///< loops with figures, a bit each
    std::uint32_t accessed_ = 0;  ///< FIFOs in advance(), a bit each
    std::uint32_t blocked_at_ = 0;
    std::uint32_t waited_ = 0;
    Ports::Number outlook_ports_ = 0;
    bool frozen_ = false;
    unsigned parked_at_ = no_port;
};

}  // namespace dataflow::timing
