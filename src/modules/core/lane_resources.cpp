#include "modules/core/lane_resources.hpp"

#include <algorithm>

#include "faster/config/lane_design.hpp"

namespace faster {

namespace {

UnitKey region_key(AcceleratorConfig const& config) {
    return choice_key("region", config.inlier_unit.sweep_region == SweepRegion::touched, "touched");
}
UnitKey buffers_key(int buffers) { return number_key("buffers", buffers, 1); }
UnitKey window_key(AcceleratorConfig const& config) { return number_key("window", config.window, 200); }

/// A memory in banks: addresses, and which lane and which buffer a port serves. Its block RAMs are counted for
/// themselves.
UnitLogic banks_of(AcceleratorConfig const& config, Machine const& machine, char const* name, char const* unit,
                   int buffers) {
    MachineMemory const& memory = machine.memories[machine.memory(name)];
    if (!banks_belong_to_lanes(config, memory))
        return {choice_of_banks(machine, {name}), {}};
    ResourcePart part = synthesized_units().on_grid(unit, "banks", static_cast<double>(memory.partition.banks()),
                                                    "buffers", static_cast<double>(buffers));
    part.amount.ramb36 = 0;
    bool const are_as_synthesized = config.window == 200 && config.inlier_unit.sweep_lanes == config.rasterizer.lanes;
    if (!are_as_synthesized)
        part.basis = std::max(part.basis, ResourceBasis::interpolated);
    // Its paths hardly depend on how many banks there are.
    return {{std::move(part)},
            synthesized_paths().paths(
                unit, {{"banks", memory.partition.banks() > 1 ? "5" : "1"}, {"buffers", std::to_string(buffers)}})};
}

UnitLogic lane_logic(char const* unit, int lanes, std::vector<UnitKey> keys) {
    keys.push_back(number_key("lanes", lanes, 1));
    UnitLogic logic = synthesized_logic(unit, keys);
    if (lanes != 1 && lanes != 5 && lanes != 6 && lanes != 10)
        logic.paths = paths_with_lanes(unit, lanes);
    return logic;
}

}  // namespace

UnitLogic lane_rasterizer_logic(AcceleratorConfig const& config) {
    return lane_logic(
        "lane_rasterizer", config.rasterizer.lanes,
        {region_key(config), window_key(config), number_key("setups", config.rasterizer.setup_overlap, 12),
         number_key("vertex_xy", config.fraction_bits.vertex_xy, 4)});
}

UnitLogic lane_map_builder_logic(AcceleratorConfig const& config, Machine const& machine) {
    UnitLogic logic = lane_logic("lane_map_builder", config.rasterizer.lanes,
                                 {region_key(config), buffers_key(config.edge_map.buffers), window_key(config)});
    if (config.edge_map.buffers == 1)
        logic += lane_map_output_logic(config);
    logic += banks_of(config, machine, "object_map", "banked_map", config.edge_map.buffers);
    return logic;
}

UnitLogic lane_map_output_logic(AcceleratorConfig const& config) {
    return lane_logic("lane_map_output", config.inlier_unit.sweep_lanes,
                      {buffers_key(config.edge_map.buffers), window_key(config)});
}

UnitLogic lane_observation_logic(AcceleratorConfig const& config) {
    UnitLogic logic =
        lane_logic("lane_observation_reader", config.inlier_unit.sweep_lanes, {region_key(config), window_key(config)});
    if (config.inlier_unit.sweep_region == SweepRegion::touched)
        logic.parts.push_back(table_of_valid_depths());
    return logic;
}

UnitLogic lane_inlier_logic(AcceleratorConfig const& config, Machine const& machine) {
    UnitLogic logic = lane_logic("lane_inlier_unit", config.rasterizer.lanes,
                                 {region_key(config), buffers_key(config.inlier_unit.buffers), window_key(config),
                                  number_key("vertex_xy", config.fraction_bits.vertex_xy, 4),
                                  number_key("area_reciprocal", config.fraction_bits.area_reciprocal, 30),
                                  number_key("fragment_depth", config.fraction_bits.fragment_depth, 18)});
    if (config.inlier_unit.buffers == 1)
        logic += lane_sweep_logic(config);
    logic += banks_of(config, machine, "depth_buffer", "banked_depths", config.inlier_unit.buffers);
    return logic;
}

UnitLogic lane_sweep_logic(AcceleratorConfig const& config) {
    UnitLogic logic = lane_logic("lane_sweep", config.inlier_unit.sweep_lanes,
                                 {region_key(config), buffers_key(config.inlier_unit.buffers), window_key(config)});
    if (counts_hidden(config.inlier_unit))
        logic += lane_logic("lane_hidden_pixels", config.inlier_unit.sweep_lanes, {});
    return logic;
}

}  // namespace faster
