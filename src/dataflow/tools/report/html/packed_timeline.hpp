#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/figures/sample_timeline.hpp"

namespace dataflow::report {

/// A sample's timeline as a page holds it: as JSON, deflated, and in base64.
///
///     items      what bars are of: [module, kind, item]
///     levels     from coarse to fine, each with all bars of the sample; those of one item with less than `resolution`
///                cycles between them are one. By column: `item`, its number; `begin`, cycles after the bar before;
///                `length`; `gaps`, cycles of the length that lie between what was made one; `iterations`; `spans`,
///                how many were made one
///     occupancy  as in timeline_data()
struct PackedTimeline {
    std::uint64_t core = 0;
    std::uint64_t sample = 0;
    Cycles begin = 0;
    Cycles end = 0;  ///< one past its last cycle
    std::string packed;
};

/// The coarsest level is as fine as a wide screen, the finest as fine as `most_bars` bars can be.
PackedTimeline packed_timeline(Machine const& machine, SampleTimeline const& timeline, std::size_t most_bars);

/// As a page has it in its list. `is`: what the sample stands for, such as "slowest".
Json packed_timeline_json(PackedTimeline const& timeline, std::vector<std::string> const& is);

}  // namespace dataflow::report
