#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// How many samples took how long. Bin i counts latencies from first + i * width up to the next bin's first cycle.
struct LatencyHistogram {
    Cycles first = 0;  ///< a multiple of width
    Cycles width = 1;  ///< 1, 2 or 5 times a power of ten, so that there are at most 30 bins
    std::vector<std::uint64_t> counts;
};

/// `latencies` ascend; none give no bins.
LatencyHistogram latency_histogram(std::vector<Cycles> const& latencies);

/// A sample that stands for others.
struct StandoutSample {
    char const* is;  ///< median, slowest, fastest
    SampleStatistics const* sample;
};

/// By latency; of equals the first. One sample may be all of them; a run without samples has none.
std::vector<StandoutSample> standout_samples(RunStatistics const& run);

/// Latencies of all samples, ascending.
std::vector<Cycles> sorted_latencies(RunStatistics const& run);

/// The latency that `share` (0..1) of the samples do not exceed; `sorted` is not empty.
Cycles latency_at(std::vector<Cycles> const& sorted, double share);

}  // namespace dataflow::report
