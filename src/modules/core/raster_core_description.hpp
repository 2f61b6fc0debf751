#pragma once
#include "faster/accelerator_config.hpp"
#include "kernel/machine/module_description.hpp"

namespace faster {

/// The dataflow region of SPEC section 1: its modules, each of which describes itself, and the FIFOs between them.
CoreDescription describe_raster_core(AcceleratorConfig const& config);

}  // namespace faster
