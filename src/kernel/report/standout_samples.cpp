#include "kernel/report/standout_samples.hpp"

#include <algorithm>

namespace faster::report {

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

}  // namespace faster::report
