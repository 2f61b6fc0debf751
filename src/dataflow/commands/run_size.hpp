#pragma once
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow {

/// Says how large a run will be, as announce() does. A workload that has no idea of its iterations is timed: its first
/// samples are simulated by a process of their own, if there are enough samples for that to be little of the run.
void announce_run(RunConfig const& config, Machine const& machine, Workload& workload, bool force);

}  // namespace dataflow
