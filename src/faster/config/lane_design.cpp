#include "faster/config/lane_design.hpp"

namespace faster {

bool has_lane_core(AcceleratorConfig const& config) {
    return config.flow == Flow::faster && config.edge_map.algorithm == EdgeMapAlgorithm::inner_border &&
           config.edge_map.clearing == MapClearing::on_read_out && config.rasterizer.scan == ScanPolicy::spans &&
           config.rasterizer.setup_overlap > 0 && config.rasterizer.edge_tokens == EdgeTokens::object &&
           config.inlier_unit.clearing == MapClearing::on_read_out &&
           config.inlier_unit.fragment_loop == FragmentLoop::flattened;
}

bool banks_belong_to_lanes(AcceleratorConfig const& config, MachineMemory const& memory) {
    PartitionConfig const& partition = config.memory(memory.name).partition;
    auto const banks = static_cast<int>(memory.partition.banks());
    bool const are_columns = banks == 1 || (partition.type == PartitionType::cyclic && partition.dimension == 2);
    return are_columns && banks % config.rasterizer.lanes == 0 && banks % config.inlier_unit.sweep_lanes == 0;
}

}  // namespace faster
