#include "kernel/report/latencies.hpp"

#include <algorithm>

namespace faster::report {

std::vector<Cycles> sorted_latencies(RunStatistics const& run) {
    std::vector<Cycles> latencies;
    for (SampleStatistics const& sample : run.samples)
        latencies.push_back(sample.latency_cycles());
    std::sort(latencies.begin(), latencies.end());
    return latencies;
}

Cycles latency_at(std::vector<Cycles> const& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace faster::report
