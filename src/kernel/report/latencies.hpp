#pragma once
#include <vector>

#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// Latencies of all samples, ascending.
std::vector<Cycles> sorted_latencies(RunStatistics const& run);

/// The latency that `share` (0..1) of the samples do not exceed; `sorted` is not empty.
Cycles latency_at(std::vector<Cycles> const& sorted, double share);

}  // namespace faster::report
