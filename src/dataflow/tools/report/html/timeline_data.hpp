#pragma once
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/figures/sample_timeline.hpp"

namespace dataflow::report {

/// Spans of the same module and item that are too close to each other to be told apart in a picture.
struct MergedSpan {
    TimelineSpan extent;      ///< from the first one's begin to the last one's end; count is the sum of theirs
    Cycles cycles = 0;        ///< inside the loops, or stalled: gaps left out
    std::uint64_t spans = 0;  ///< how many they are
};

/// Merges neighbours with less than `resolution` cycles between them, so that the number of bars depends on the size of
/// the picture and not on the length of the sample. `spans` by begin; so is the result.
std::vector<MergedSpan> merged_spans(std::vector<TimelineSpan> const& spans, Cycles resolution);

/// Tokens in a FIFO during one part of a sample.
struct OccupancyPart {
    double mean = 0;
    std::uint64_t max = 0;
};

/// Divides begin..end into at most `parts` parts of the same length. A FIFO is empty before its first point.
std::vector<OccupancyPart> occupancy_profile(std::vector<OccupancyPoint> const& points, Cycles begin, Cycles end,
                                             std::size_t parts);

/// Bars closer together than this cannot be told apart where all of the sample is shown.
Cycles coarse_resolution(SampleTimeline const& timeline);

/// What a span is of: module, kind, item.
Json span_item(Machine const& machine, TimelineSpan const& span);
/// 0 of a stall.
std::uint64_t iterations_of(MergedSpan const& span);

/// By FIFO, in so many parts of the sample as a small picture can show: mean and largest number of tokens.
Json occupancy_data(Machine const& machine, SampleTimeline const& timeline);

/// A sample's timeline as pages draw it: with as many bars and points as a wide screen can show.
Json timeline_data(Machine const& machine, SampleTimeline const& timeline);

}  // namespace dataflow::report
