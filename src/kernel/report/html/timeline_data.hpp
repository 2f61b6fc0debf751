#pragma once
#include "kernel/base/json.hpp"
#include "kernel/figures/sample_timeline.hpp"
#include "kernel/machine/machine.hpp"
#include "kernel/report/html/timeline_view.hpp"

namespace faster::report {

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

}  // namespace faster::report
