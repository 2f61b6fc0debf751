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
};

/// The counters as columns of samples.csv. A counter with a row here is in every file that tells of samples, in
/// comparisons, budgets, event files and waveforms.
inline constexpr Column<SampleCounters> sample_counters[]{
    {"valid_raster", "draws", &SampleCounters::valid_raster, Tells::result,
     "fragments that went into the depth buffer, redraws included"},
    {"valid_depth", "px", &SampleCounters::valid_depth, Tells::result,
     "inner window pixels with observed depth <= 3.0 m; missing readings (0) count"},
    {"inlier", "px", &SampleCounters::inlier, Tells::result, "pixels whose rendered and observed depth agree"},
    {"valid_edge", "px", &SampleCounters::valid_edge, Tells::result, "inner window pixels that are rendered edges"},
    {"edge_inlier", "px", &SampleCounters::edge_inlier, Tells::result,
     "inliers that are both rendered and observed edges"},
};
constexpr std::size_t sample_counter_count = std::size(sample_counters);

/// The counter of a column.
inline std::uint64_t& counter(Column<SampleCounters> const& column, SampleCounters& counters) {
    return counters.*std::get<std::uint64_t SampleCounters::*>(column.member);
}
inline std::uint64_t counter(Column<SampleCounters> const& column, SampleCounters const& counters) {
    return counters.*std::get<std::uint64_t SampleCounters::*>(column.member);
}

/// As numbers in the order of the columns, and back.
inline std::vector<std::uint64_t> values_of(SampleCounters const& counters) {
    std::vector<std::uint64_t> values;
    for (auto const& column : sample_counters)
        values.push_back(counter(column, counters));
    return values;
}
inline SampleCounters counters_from(std::vector<std::uint64_t> const& values) {
    SampleCounters counters;
    for (std::size_t i = 0; i < sample_counter_count; ++i)
        counter(sample_counters[i], counters) = values.at(i);
    return counters;
}

inline bool operator==(SampleCounters const& a, SampleCounters const& b) {
    return std::all_of(std::begin(sample_counters), std::end(sample_counters),
                       [&](auto const& column) { return counter(column, a) == counter(column, b); });
}

}  // namespace faster
