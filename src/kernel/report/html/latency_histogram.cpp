#include "kernel/report/html/latency_histogram.hpp"

namespace faster::report {

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

}  // namespace faster::report
