#include "faster/loop_accesses.hpp"

#include "faster/edge_map_design.hpp"
#include "faster/extract_design.hpp"
#include "faster/sweep_design.hpp"

namespace faster {
namespace {

constexpr PixelOffset own{0, 0};
constexpr PixelOffset above{-1, 0};
constexpr PixelOffset below{1, 0};

AccessPattern pattern_of(std::uint64_t touches) {
    AccessPattern pattern;
    if ((touches & map_touch::read_own) != 0)
        pattern.reads.push_back(own);
    if ((touches & map_touch::read_vertical) != 0)
        pattern.reads.insert(pattern.reads.end(), {above, below});
    if ((touches & map_touch::write_own) != 0)
        pattern.writes.push_back(own);
    if ((touches & map_touch::write_vertical) != 0)
        pattern.writes.insert(pattern.writes.end(), {above, below});
    return pattern;
}

std::vector<MemoryAccess> to_maps(PerMap const& touches, int lanes = 1) {
    std::vector<MemoryAccess> accesses;
    if (touches.edge_map != 0)
        accesses.push_back({BramId::edge_map, widened(pattern_of(touches.edge_map), lanes)});
    if (touches.object_map != 0)
        accesses.push_back({BramId::object_map, widened(pattern_of(touches.object_map), lanes)});
    return accesses;
}

}  // namespace

std::vector<MemoryAccess> loop_accesses(LoopId id, AcceleratorConfig const& config) {
    EdgeMapDesign const& design = design_of(config.edge_map.algorithm);
    switch (configured_as(id)) {
        case LoopId::edge_clear:
            return to_maps(design.clear);
        case LoopId::token:
            return to_maps(design.token, config.flow == Flow::faster ? config.rasterizer.lanes : 1);
        case LoopId::output:
            return to_maps(output_touches(config.edge_map), config.inlier_unit.sweep_lanes);
        case LoopId::depth_clear:
            return {{BramId::depth_buffer, {{}, {own}}}};
        case LoopId::fragment:
            return {{BramId::depth_buffer, widened({{own}, {own}}, config.rasterizer.lanes)}};
        case LoopId::sweep:
            return {{BramId::depth_buffer, sweep_design(config).accesses}};
        case LoopId::extract:
            return {{BramId::depth_buffer, extract_design(config).accesses}};
        case LoopId::vertex:
        case LoopId::scan:
        case LoopId::read:
        default:
            break;
    }
    return {};
}

}  // namespace faster
