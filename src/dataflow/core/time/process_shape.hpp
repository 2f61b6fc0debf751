#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/time/initiation_interval.hpp"
#include "dataflow/core/time/operation.hpp"

namespace dataflow::timing {

/// A FIFO that a loop reads or writes: the token of iteration i is taken, or leaves, in step i * II + stage.
struct LoopAccess {
    unsigned port = 0;
    Cycles stage = 0;  ///< below the loop's depth; of a write, its latency Lw
};

/// One loop of a process (docs/timing-model.md#pipelined-loops). One that is not pipelined is one whose interval is its
/// depth, and so has one iteration at a time.
struct LoopShape {
    std::string name;
    InitiationInterval interval;
    Cycles depth = 1;                          ///< L
    Cycles entry_states = 0, exit_states = 0;  ///< cycles before the first iteration, and behind the last
    std::vector<LoopAccess> writes;
    /// All ports that the loop reads. May be empty if it writes none, and each iteration reads in its first step.
    std::vector<LoopAccess> reads;
    /// By number of a dependence: the fewest steps from the begin of an iteration to that of one that accesses what it
    /// writes. 1: nobody waits. Empty: for none; otherwise iterations read FIFOs in their first step, and write none.
    std::vector<Cycles> interlock_spans;
    bool makes_attempts = false;  ///< its iterations may access some of those ports without waiting
    bool rewinds = false;         ///< the next call's iterations follow at once, see docs/timing-model.md#rewind
    bool uses_stream = false;     ///< each iteration takes a token of the process's memory stream, in its first step

    /// In which an iteration accesses anything that the loop names; never, if it names nothing.
    Cycles first_stage() const;
};

/// What leaving a loop adds to its counters.
struct LoopEnd {
    std::uint64_t entries = 0;
    Cycles port_conflict_beyond_end = 0;
    Cycles recurrence_beyond_end = 0;
};
/// After so many iterations; more than iterations_that_count() need not be told apart.
LoopEnd loop_end(LoopShape const& loop, std::uint64_t iterations);
/// More iterations than so many cost a loop no more at its end.
std::uint64_t iterations_that_count(LoopShape const& loop);

/// Accesses of a loop that share a step of each iteration.
struct LoopPhase {
    Cycles offset = 0;                                      ///< steps after the iteration's first, below II
    std::vector<std::pair<unsigned, std::uint64_t>> ports;  ///< port, and iterations that its token is behind
};

/// How the steps of a loop are laid out. `aligned`: all accesses of an iteration fall in one step and have one
/// direction, so that the pipeline needs no memory; otherwise a delay line holds what the last iterations have yet to
/// read and to write.
struct LoopPlan {
    explicit LoopPlan(LoopShape const& loop);
    /// Of a loop told by steps instead of iterations, and behind those by as many steps as the longest lag: see
    /// LoopsInSteps. Where an iteration accesses ports in two of its steps, it is what it does from the later one on.
    LoopPlan in_steps() const;
    /// Steps from an iteration's first to the one that accesses a port; none: it does not.
    std::optional<Cycles> step_of(unsigned port) const;

    Cycles ii = 1;
    Cycles fill = 0;         ///< steps before the first access of the first iteration
    std::int64_t drain = 0;  ///< steps after the last iteration's II; may be negative
    bool aligned = true;
    std::uint64_t longest_lag = 0;      ///< iterations
    std::uint64_t counting = 1;         ///< iterations_that_count()
    std::size_t delay_line_length = 1;  ///< a power of two above longest_lag, so that nothing need be divided
    std::vector<LoopPhase> phases;
};

/// When a call of a process begins: so many cycles after the region that it is part of does.
struct CallStart {
    Cycles after = 0;
    bool is_in_turn = false;    ///< each call of the region begins anew; otherwise there is one begin, cycle 0
    bool ends_samples = false;  ///< stamps tell when calls end, not when they begin
};

/// What a process is, as far as time is concerned, besides its ports: the same for all copies of it.
struct ProcessShape {
    std::vector<LoopShape> loops;
    std::vector<LoopPlan> plans;  ///< of the loops
    Cycles setup_cycles = 0;      ///< of one setup
    bool sets_up_ahead = false;  ///< it has a loop that both reads and writes, and setups may take their time beside it
    bool has_interlocks = false;  ///< iterations of a loop may wait for others to write
    CallStart call_start;
    Cycles stamps_back = 0;      ///< cycles between what a stamp notes and the local time
    Cycles flushing_stages = 0;  ///< of its FlushingPipeline; 0: it has none
    unsigned flushing_port = 0;  ///< by which tokens leave that

    /// Whether a loop that rewinds need not drain before it: a stamp, a call not in turn, the same loop entered again.
    bool goes_on_with(Operation const& operation, unsigned loop) const;
    /// The shape of a process that finds everything there which it takes from memory, at this port.
    ProcessShape fed(unsigned stream_port) const;
};

/// Where the entries into a process's loops begin, as it tells its operations: a loop that rewinds is entered once for
/// all calls that it goes on with.
struct LoopEntries {
    unsigned loop = 0;   ///< entered last
    bool rests = false;  ///< that is left, and nothing told that it drains before

    /// Whether an operation, the next one told, begins an entry into its loop.
    bool take(Operation const& operation, ProcessShape const& shape);
};

}  // namespace dataflow::timing
