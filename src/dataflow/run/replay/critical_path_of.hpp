#pragma once
#include <vector>

#include "kernel/figures/critical_path.hpp"
#include "kernel/machine/machine.hpp"
#include "kernel/timing/core_timing.hpp"

namespace faster::replay {

/// The critical path to the end of a run that ended, in numbers of the machine's parts. Its cores must have left
/// trails. Nothing without samples.
CriticalPath critical_path_of(std::vector<timing::CoreTiming const*> const& cores, Machine const& machine);

}  // namespace faster::replay
