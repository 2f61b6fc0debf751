#pragma once
#include "dataflow/base/device/resources.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What one raster core takes, module by module and FIFO by FIFO: from rtl/resources.csv, and counted where the
/// register-transfer twin has nothing to synthesize. Beside the cores: what the thesis's chip has (Table 6.2) and ten
/// cores of the default design do not, shared out evenly.
ToldResources core_resources(AcceleratorConfig const& config, Machine const& machine);

}  // namespace faster
