#pragma once
#include <vector>

#include "kernel/base/json.hpp"
#include "kernel/report/html/html_report.hpp"

namespace faster::report {

/// The block RAMs of a core, with the port conflicts of all cores; what its FIFOs are kept in; and what the device has.
Json area_data(RunStatistics const& run, std::vector<FifoCost> const& fifo_costs);

}  // namespace faster::report
