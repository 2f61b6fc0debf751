#pragma once
#include <algorithm>
#include <iterator>
#include <vector>

#include "dataflow/base/column.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What a sample scores, and the token of `result` (docs/function.md#inlierunit). The counters do not wrap.
struct SampleCounters {
    std::uint64_t valid_raster = 0;
    std::uint64_t valid_depth = 0;
    std::uint64_t inlier = 0;
    std::uint64_t valid_edge = 0;
    std::uint64_t edge_inlier = 0;
    std::uint64_t hidden = 0;
    std::uint64_t visible_top = 0;
    std::uint64_t visible_left = 0;
    std::uint64_t visible_bottom = 0;
    std::uint64_t visible_right = 0;
};

/// The counters as columns of samples.csv. A counter with a row here is in every file that tells of samples, in
/// comparisons, budgets, event files and waveforms. The last ones are there with inlier_unit.hidden counted only.
inline constexpr Column<SampleCounters> sample_counters[]{
    {"valid_raster", "draws", &SampleCounters::valid_raster, Tells::result,
     "fragments that went into the depth buffer, redraws included"},
    {"valid_depth", "px", &SampleCounters::valid_depth, Tells::result,
     "inner window pixels with observed depth <= 3.0 m; missing readings (0) count"},
    {"inlier", "px", &SampleCounters::inlier, Tells::result, "pixels whose rendered and observed depth agree"},
    {"valid_edge", "px", &SampleCounters::valid_edge, Tells::result, "inner window pixels that are rendered edges"},
    {"edge_inlier", "px", &SampleCounters::edge_inlier, Tells::result,
     "inliers that are both rendered and observed edges"},
    {"hidden", "px", &SampleCounters::hidden, Tells::result, "drawn pixels in front of which something was measured"},
    {"visible_top", "px", &SampleCounters::visible_top, Tells::result,
     "first row of the window with a drawn, not hidden pixel; 0: there is none"},
    {"visible_left", "px", &SampleCounters::visible_left, Tells::result, "first column with one"},
    {"visible_bottom", "px", &SampleCounters::visible_bottom, Tells::result, "last row with one"},
    {"visible_right", "px", &SampleCounters::visible_right, Tells::result, "last column with one"},
};
constexpr std::size_t hidden_counter_count = 5;  ///< the last of them
constexpr std::size_t sample_counter_count = std::size(sample_counters);

/// How many counters a sample has: the first of the columns.
constexpr std::size_t counters_of(bool counts_hidden) {
    return sample_counter_count - (counts_hidden ? 0 : hidden_counter_count);
}

/// The counter of a column.
inline std::uint64_t& counter(Column<SampleCounters> const& column, SampleCounters& counters) {
    return counters.*std::get<std::uint64_t SampleCounters::*>(column.member);
}
inline std::uint64_t counter(Column<SampleCounters> const& column, SampleCounters const& counters) {
    return counters.*std::get<std::uint64_t SampleCounters::*>(column.member);
}

/// The first `count` as numbers in the order of the columns, and back: those that are left out are 0.
inline std::vector<std::uint64_t> values_of(SampleCounters const& counters, std::size_t count = sample_counter_count) {
    std::vector<std::uint64_t> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(counter(sample_counters[i], counters));
    return values;
}
inline SampleCounters counters_from(std::vector<std::uint64_t> const& values) {
    SampleCounters counters;
    for (std::size_t i = 0; i < values.size(); ++i)
        counter(sample_counters[i], counters) = values[i];
    return counters;
}

inline bool operator==(SampleCounters const& a, SampleCounters const& b) {
    return std::all_of(std::begin(sample_counters), std::end(sample_counters),
                       [&](auto const& column) { return counter(column, a) == counter(column, b); });
}

}  // namespace faster
