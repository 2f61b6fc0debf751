#pragma once
#include <array>

#include "dataflow/run/figures/run_statistics.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// Of a sample's result, in the order of its row in samples.csv (docs/formats.md#samplescsv-one-row-per-sample).
constexpr std::array<char const*, 5> counter_names{"valid_raster", "valid_depth", "inlier", "valid_edge",
                                                   "edge_inlier"};

inline Counters counters_of(SampleCounters const& counters) {
    return {counters.valid_raster, counters.valid_depth, counters.inlier, counters.valid_edge, counters.edge_inlier};
}

/// Throws std::out_of_range if it has no result, as of a run that got stuck.
inline SampleCounters counters_of(SampleStatistics const& sample) {
    static_cast<void>(sample.counters.at(counter_names.size() - 1));
    return counters_from(sample.counters);
}

}  // namespace faster::testing
