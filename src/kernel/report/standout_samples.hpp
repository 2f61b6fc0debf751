#pragma once
#include <vector>

#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// A sample that stands for others.
struct StandoutSample {
    char const* is;  ///< median, slowest, fastest
    SampleStatistics const* sample;
};

/// By latency; of equals the first. One sample may be all of them; a run without samples has none.
std::vector<StandoutSample> standout_samples(RunStatistics const& run);

}  // namespace faster::report
