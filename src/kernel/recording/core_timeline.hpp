#pragma once
#include <array>
#include <vector>

#include "kernel/figures/sample_timeline.hpp"
#include "kernel/recording/vcd_core.hpp"

namespace faster::recording {

/// What the modules of one core did in a recorded window, for a look from further away than a waveform's.
struct CoreTimeline {
    struct Sample {
        std::size_t sample = 0;
        Cycles begin = 0;       ///< the rasterizer reads its header
        Cycles end = 0;         ///< one past the cycle in which the collector reads its result, or past the window
        bool complete = false;  ///< ends in the window
    };
    std::size_t core = 0;
    Parts parts;
    std::vector<TimelineSpan> spans;  ///< by begin
    std::array<std::vector<OccupancyPoint>, fifo_count> occupancy;
    std::vector<Sample> samples;
};

/// How much is drawn together.
struct TimelineGrain {
    Cycles stall_gap = 16;         ///< stalls on one FIFO no further apart than this are one span
    Cycles occupancy_bucket = 64;  ///< an occupancy is the largest in so many cycles
};

/// Spans are cut off at the window's borders.
CoreTimeline make_timeline(RecordedCore const& core, TimelineGrain const& grain);

}  // namespace faster::recording
