#pragma once
#include <string>
#include <vector>

#include "dataflow/base/device/resources.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What a module takes besides the unit of the thesis's core: lanes as they are synthesized, and by hand what no
/// register-transfer twin has in this way. None where that unit has everything. Widths are those of the default
/// formats. docs/hardware.md tells how each number comes about.
using ResourceParts = std::vector<ResourcePart>;
ResourceParts counted_in_vertex_transform(AcceleratorConfig const& config);
ResourceParts counted_in_rasterizer(AcceleratorConfig const& config);
ResourceParts counted_in_edge_map_builder(AcceleratorConfig const& config, Machine const& machine);
ResourceParts counted_in_observation_reader(AcceleratorConfig const& config);
ResourceParts counted_in_inlier_unit(AcceleratorConfig const& config, Machine const& machine);
/// Multiplexers of memories in banks or buffers.
ResourceParts choice_of_banks(Machine const& machine, std::vector<std::string> const& memories);
/// With a touched region: four words of the table of valid depths.
ResourcePart table_of_valid_depths();
/// Of edge_map_output and inlier_sweep: the control that a second buffer takes.
ResourceParts counted_in_read_out();

}  // namespace faster
