#pragma once
#include "modules/accelerator.hpp"
#include "stats/run_statistics.hpp"

namespace faster {

/// Reads the figures of a finished (or stuck) run out of the machine.
RunStatistics collect(Accelerator const& accelerator, AcceleratorConfig const& config, Stimulus const& stimulus);

}  // namespace faster
