#pragma once
#include "kernel/base/json.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::explore {

/// What the page shows of a retimed run, FIFOs and loops of all cores together.
Json figures_json(RunStatistics const& run);

}  // namespace faster::explore
