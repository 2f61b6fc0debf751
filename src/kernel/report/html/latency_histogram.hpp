#pragma once
#include <cstdint>
#include <vector>

#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// How many samples took how long. Bin i counts latencies from first + i * width up to the next bin's first cycle.
struct LatencyHistogram {
    Cycles first = 0;  ///< a multiple of width
    Cycles width = 1;  ///< 1, 2 or 5 times a power of ten, so that there are at most 30 bins
    std::vector<std::uint64_t> counts;
};

/// `latencies` ascend; none give no bins.
LatencyHistogram latency_histogram(std::vector<Cycles> const& latencies);

}  // namespace faster::report
