#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// What one module did from one cycle to another.
struct TimelineSpan {
    enum class Kind { loop, empty_stall, full_stall, memory_stall };
    std::size_t module = 0;  ///< number of a process of the machine
    Kind kind = Kind::loop;
    std::size_t item = 0;  ///< number of the loop, or of the FIFO that caused the stall; of no FIFO: memory did
    Cycles begin = 0;
    Cycles end = 0;    ///< one past the last cycle
    Cycles count = 0;  ///< iterations of a loop; stalled cycles: short stalls on one FIFO close together are one span
};

/// Tokens in a FIFO from a cycle on.
struct OccupancyPoint {
    Cycles cycle = 0;
    std::uint64_t tokens = 0;
};

/// What all modules of a core did while it scored one sample. Stalls lie inside the loops they interrupt.
struct SampleTimeline {
    std::uint64_t core = 0;
    std::uint64_t sample = 0;
    Cycles begin = 0;                                    ///< the sample begins
    Cycles end = 0;                                      ///< one past its last cycle
    std::vector<TimelineSpan> spans;                     ///< by begin
    std::vector<std::vector<OccupancyPoint>> occupancy;  ///< by FIFO
};

}  // namespace dataflow
