#pragma once
#include <vector>

#include "common/tokens.hpp"
#include "config/accelerator_config.hpp"
#include "config/core_share.hpp"
#include "stats/run_statistics.hpp"
#include "timing/core_timing.hpp"

namespace faster::retiming {

/// A core that has done all it can.
struct FinishedCore {
    CoreShare share;
    timing::CoreTiming& timing;
    SampleCounters const* counters;  ///< by sample of its share, as far as it got
};

/// The figures of a finished (or stuck) run.
RunStatistics collect(std::vector<FinishedCore> const& cores, AcceleratorConfig const& config);

}  // namespace faster::retiming
