#pragma once
#include <vector>

#include "common/tokens.hpp"
#include "faster/accelerator_config.hpp"
#include "kernel/figures/run_statistics.hpp"
#include "kernel/machine/core_share.hpp"
#include "kernel/timing/core_timing.hpp"

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
