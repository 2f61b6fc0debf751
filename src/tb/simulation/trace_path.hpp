#pragma once
#include "kernel/figures/critical_path.hpp"
#include "modules/accelerator.hpp"

namespace faster {

/// The critical path to the end of a run that ended, with the names of SPEC section 1. Its cores must have left trails.
/// Nothing without samples.
CriticalPath trace_path(Accelerator const& accelerator);

}  // namespace faster
