#pragma once
#include "dataflow/core/machine/module_description.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// The dataflow region of docs/architecture.md#the-machine: its modules, each of which describes itself, and the FIFOs
/// between them.
CoreDescription describe_raster_core(AcceleratorConfig const& config);

}  // namespace faster
