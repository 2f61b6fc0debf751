#pragma once
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/run/figures/critical_path.hpp"

namespace dataflow::replay {

/// The critical path to the end of a run that ended, in numbers of the machine's parts. Its cores must have left
/// trails. Nothing without samples.
CriticalPath critical_path_of(std::vector<timing::CoreTiming const*> const& cores, Machine const& machine);

}  // namespace dataflow::replay
