#include "dataflow/tools/report/latencies.hpp"

#include <algorithm>

namespace dataflow::report {

namespace {

constexpr Cycles most_bins = 30;

/// The next larger of 1, 2, 5, 10, 20, 50, ...
Cycles next_width(Cycles width) {
    Cycles leading = width;
    while (leading >= 10)
        leading /= 10;
    return leading == 2 ? width / 2 * 5 : width * 2;
}

}  // namespace

LatencyHistogram latency_histogram(std::vector<Cycles> const& latencies) {
    LatencyHistogram histogram;
    if (latencies.empty())
        return histogram;
    auto const bin_of = [&histogram](Cycles latency) { return latency / histogram.width; };
    while (bin_of(latencies.back()) - bin_of(latencies.front()) >= most_bins)
        histogram.width = next_width(histogram.width);
    Cycles const first_bin = bin_of(latencies.front());
    histogram.first = first_bin * histogram.width;
    histogram.counts.resize(bin_of(latencies.back()) - first_bin + 1);
    for (Cycles const latency : latencies)
        ++histogram.counts[bin_of(latency) - first_bin];
    return histogram;
}

std::vector<StandoutSample> standout_samples(RunStatistics const& run) {
    std::vector<SampleStatistics const*> by_latency;
    for (SampleStatistics const& sample : run.samples)
        by_latency.push_back(&sample);
    if (by_latency.empty())
        return {};
    std::sort(by_latency.begin(), by_latency.end(), [](SampleStatistics const* a, SampleStatistics const* b) {
        return std::make_pair(a->latency_cycles(), a->sample) < std::make_pair(b->latency_cycles(), b->sample);
    });
    auto const is_as_slow = [slowest = by_latency.back()->latency_cycles()](SampleStatistics const* sample) {
        return sample->latency_cycles() == slowest;
    };
    return {{"median", by_latency[(by_latency.size() - 1) / 2]},
            {"slowest", *std::find_if(by_latency.begin(), by_latency.end(), is_as_slow)},
            {"fastest", by_latency.front()}};
}

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

}  // namespace dataflow::report
