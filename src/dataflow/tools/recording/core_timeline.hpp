#pragma once
#include <tuple>
#include <vector>

#include "dataflow/run/figures/sample_timeline.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"

namespace dataflow::recording {

/// What the modules of one core did in a recorded window, for a look from further away than a waveform's.
struct CoreTimeline {
    struct Sample {
        std::size_t sample = 0;
        Cycles begin = 0;
        Cycles end = 0;         ///< one past its last cycle, or past the window
        bool complete = false;  ///< ends in the window
    };
    std::size_t core = 0;
    Machine const* machine = nullptr;
    std::vector<TimelineSpan> spans;                     ///< by begin
    std::vector<std::vector<OccupancyPoint>> occupancy;  ///< by FIFO
    std::vector<Sample> samples;
};

/// How much is drawn together.
struct TimelineGrain {
    Cycles stall_gap = 16;         ///< stalls on one FIFO no further apart than this are one span
    Cycles occupancy_bucket = 64;  ///< an occupancy is the largest in so many cycles
};

/// The order of spans: by begin; what encloses others first, as a loop does its stalls. The same from both engines.
inline bool outermost_first(TimelineSpan const& a, TimelineSpan const& b) {
    return std::tie(a.begin, b.end, a.module, a.kind, a.item) < std::tie(b.begin, a.end, b.module, b.kind, b.item);
}

/// Spans are cut off at the window's borders.
CoreTimeline make_timeline(RecordedCore const& core, TimelineGrain const& grain);

/// Of a window that is one sample, as exactly as it can be: who draws it takes means.
SampleTimeline sample_timeline(RecordedCore const& core, std::size_t sample);

}  // namespace dataflow::recording
