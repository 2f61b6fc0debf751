#pragma once
#include <array>
#include <cstdint>

#include "common/tokens.hpp"

namespace faster::runs {

/// A counter by its name in samples.csv.
struct NamedCounter {
    char const* name;
    std::uint64_t SampleCounters::*value;
};

constexpr std::array<NamedCounter, 5> sample_counters{{{"valid_raster", &SampleCounters::valid_raster},
                                                       {"valid_depth", &SampleCounters::valid_depth},
                                                       {"inlier", &SampleCounters::inlier},
                                                       {"valid_edge", &SampleCounters::valid_edge},
                                                       {"edge_inlier", &SampleCounters::edge_inlier}}};

}  // namespace faster::runs
