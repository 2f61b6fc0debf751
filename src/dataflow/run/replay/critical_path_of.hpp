#pragma once
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/run/figures/critical_path.hpp"

namespace dataflow::replay {

/// The critical path to the end of a core that ended, in numbers of the machine's parts, the largest first. It must
/// have left a trail. Nothing without samples.
std::vector<PathRow> critical_path_of(timing::CoreTiming const& core, Machine const& machine);

}  // namespace dataflow::replay
