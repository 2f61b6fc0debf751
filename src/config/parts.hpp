#pragma once
#include <string>
#include <vector>

#include "config/accelerator_config.hpp"

namespace faster {

/// What decides which of the parts of machine.hpp the cores have. A core's tables of FIFOs and processes keep the
/// places of the others, which stay empty: a part's number is the same in every design.
struct Parts {
    Flow flow = Flow::faster;
    SweepRegion sweep_region = SweepRegion::window;

    constexpr Parts() = default;
    constexpr Parts(Flow its_flow, SweepRegion region = SweepRegion::window) : flow(its_flow), sweep_region(region) {}
    constexpr Parts(AcceleratorConfig const& config)
        : flow(config.flow), sweep_region(config.inlier_unit.sweep_region) {}
};

constexpr bool has_part(Parts const& parts, ModuleId id) {
    return parts.flow == Flow::faster || id != ModuleId::edge_map_builder;
}
constexpr bool has_part(Parts const& parts, FifoId id) {
    bool const is_of_region = id == FifoId::region || id == FifoId::valid_depth;
    return has_part(parts, fifo_ends[index_of(id)].writer) && has_part(parts, fifo_ends[index_of(id)].reader) &&
           (parts.sweep_region == SweepRegion::touched || !is_of_region);
}
constexpr bool has_part(Parts const& parts, LoopId id) {
    return has_part(parts, loop_names[index_of(id)].module) && (parts.flow == Flow::fpga_grip || id != LoopId::extract);
}
constexpr bool has_part(Parts const& parts, BramId id) {
    return parts.flow == Flow::faster || id == BramId::depth_buffer;
}

/// Numbers of the parts of one kind, in their order.
std::vector<std::size_t> modules_of(Parts const& parts);
std::vector<std::size_t> fifos_of(Parts const& parts);
std::vector<std::size_t> loops_of(Parts const& parts);
std::vector<std::size_t> brams_of(Parts const& parts);

/// False for the keys of parts that are not there. `key`: dotted name.
bool applies_to(Parts const& parts, std::string const& key);

}  // namespace faster
