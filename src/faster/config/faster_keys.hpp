#pragma once
#include "dataflow/core/machine/module_description.hpp"
#include "dataflow/run/config/keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Every key of FASTER, in the order of the documentation. `core`: a raster core, of any configuration.
Keys faster_keys(CoreDescription const& core);

/// Parts of faster_keys(): where an iteration's data lie, and what the machine works on.
Keys memory_placement_keys();
Keys workload_keys();

/// Part of faster_keys(): the loop around the machine. A run does not look at them.
Keys estimator_keys();

}  // namespace faster
