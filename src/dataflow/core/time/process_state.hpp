#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/time/flushing_pipeline.hpp"
#include "dataflow/core/time/ports.hpp"

namespace dataflow::timing {

/// Where a process stands in a loop whose tokens leave in different stages.
struct PipelinePosition {
    std::uint64_t iteration = 0;
    bool open = false;           ///< inside an iteration
    bool counts = false;         ///< which the module has told of; otherwise, it only lets the last ones drain
    std::size_t phase = 0;       ///< the one at hand
    Cycles offset = 0;           ///< steps since the iteration's first
    std::uint32_t gap_left = 0;  ///< silent iterations behind one with accesses
    std::uint64_t drain_left = 0;
    std::uint64_t alike = 0;  ///< of the last iterations begun, at least so many have accessed the same ports
};

/// Where a process stands. With the operations that it has yet to do and the FIFOs around it, all that decides when it
/// does what.
template <class Time> struct ProcessState {
    Time time = 0;  ///< T of docs/timing-model.md#vocabulary
    bool in_loop = false;
    unsigned loop = 0;             ///< that it is in, or was in last
    std::uint64_t iterations = 0;  ///< of the loop entry at hand
    PipelinePosition pipeline;
    std::vector<Ports::Number> delay_line;  ///< ports of the last iterations of a loop that is not aligned, a ring
    std::vector<Time> setups_done;          ///< when those begun, and not awaited yet, will be
    /// Steps in which a loop has begun nothing, as an iteration waited for a write: before which. The latest ones.
    struct WriteWait {
        std::int64_t iteration = 0;  ///< negative: before those that the state counts
        Cycles steps = 0;
    };
    std::vector<WriteWait> write_waits;
    bool rests = false;             ///< at the end of a loop that may go on with the next call's iterations
    std::uint64_t stamps_held = 0;  ///< told at rest: what follows decides what they note
    FlushingPipeline<Time> flushing;

    /// What an iteration of a loop accesses, `lag` iterations before the one at hand.
    Ports::Number delayed(std::uint64_t lag) const { return delay_line[place(pipeline.iteration - lag)]; }
    Ports::Number& delayed(std::uint64_t lag) { return delay_line[place(pipeline.iteration - lag)]; }

  private:
    std::size_t place(std::uint64_t iteration) const { return iteration & (delay_line.size() - 1); }
};

}  // namespace dataflow::timing
