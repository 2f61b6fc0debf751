#pragma once
#include "dataflow/core/machine/module_description.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Conditions under which parts of a core are there, as several modules' descriptions state them.
inline Condition finds_edges_while_drawing(AcceleratorConfig const& config) {
    return {config.flow == Flow::faster, "accelerator.flow"};
}
inline Condition extracts_edges(AcceleratorConfig const& config) {
    return {config.flow == Flow::fpga_grip, "accelerator.flow"};
}
inline Condition sweeps_touched_region(AcceleratorConfig const& config) {
    return {config.inlier_unit.sweep_region == SweepRegion::touched, "accelerator.inlier_unit.sweep_region"};
}
inline Condition has_external_memory(AcceleratorConfig const& config) {
    return {config.external_memory.model != MemoryModel::ideal, "accelerator.memory.model"};
}
inline Condition has_map_buffers(AcceleratorConfig const& config, bool two) {
    return {(config.edge_map.buffers > 1) == two, "accelerator.edge_map.buffers"};
}
inline Condition has_depth_buffers(AcceleratorConfig const& config, bool two) {
    return {(config.inlier_unit.buffers > 1) == two, "accelerator.inlier_unit.buffers"};
}

}  // namespace faster
