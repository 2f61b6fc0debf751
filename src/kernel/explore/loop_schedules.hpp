#pragma once
#include "kernel/base/json.hpp"
#include "kernel/config/run_config.hpp"

namespace faster::explore {

/// Why the loops of a configuration have their initiation intervals: of each loop what the pragma, a dependence and the
/// ports demand, and of each memory it accesses the accesses of one iteration in the fullest bank, dealt out to its
/// ports, cycle by cycle.
Json loop_schedules(RunConfig const& config);

}  // namespace faster::explore
