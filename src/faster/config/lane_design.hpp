#pragma once
#include "dataflow/core/machine/machine.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Whether it is built as the core of rtl/lanes is, whatever its numbers: its modules are then that core's units, which
/// are synthesized. The memory outside of it is no part of a core.
bool has_lane_core(AcceleratorConfig const& config);

/// Columns of a memory in cyclic banks, of which every lane has its own: no multiplexer leads from any lane to any
/// bank.
bool banks_belong_to_lanes(AcceleratorConfig const& config, MachineMemory const& memory);

}  // namespace faster
