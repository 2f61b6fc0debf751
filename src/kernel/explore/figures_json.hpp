#pragma once
#include "kernel/base/json.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::explore {

/// What the page shows of a retimed run, FIFOs and loops of all cores together.
Json figures_json(RunStatistics const& run);

/// What FIFOs and memories of all cores cost, in LUTs, if a core's FIFOs cost so much.
double cost_of_cores(Machine const& machine, double cost_of_fifos);

}  // namespace faster::explore
