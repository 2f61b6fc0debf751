#pragma once
#include "kernel/base/json.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// The block RAMs of a core, with the port conflicts of all cores, and what the device has.
Json area_data(RunStatistics const& run);

}  // namespace faster::report
