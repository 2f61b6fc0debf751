#pragma once
#include "dataflow/core/machine/machine.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/unit_logic.hpp"

namespace faster {

/// What the modules of a core with lanes take (has_lane_core): the units of rtl/lanes. With one buffer a builder and
/// an inlier unit read out by themselves, with two a process of its own does.
UnitLogic lane_rasterizer_logic(AcceleratorConfig const& config);
UnitLogic lane_map_builder_logic(AcceleratorConfig const& config, Machine const& machine);
UnitLogic lane_map_output_logic(AcceleratorConfig const& config);
UnitLogic lane_observation_logic(AcceleratorConfig const& config);
UnitLogic lane_inlier_logic(AcceleratorConfig const& config, Machine const& machine);
UnitLogic lane_sweep_logic(AcceleratorConfig const& config);

}  // namespace faster
