#pragma once
#include <string>
#include <vector>

#include "faster/accelerator_config.hpp"

namespace faster {

/// What of a configuration decides which of the parts of machine.hpp its cores have. A part's number is the same
/// whatever parts there are.
struct Parts {
    Flow flow = Flow::faster;
    SweepRegion sweep_region = SweepRegion::window;
    bool has_map_buffers = false;    ///< edge_map.buffers: 2
    bool has_depth_buffers = false;  ///< inlier_unit.buffers: 2

    constexpr Parts() = default;
    constexpr Parts(Flow its_flow) : flow(its_flow) {}
    constexpr Parts(AcceleratorConfig const& config)
        : flow(config.flow),
          sweep_region(config.inlier_unit.sweep_region),
          has_map_buffers(config.flow == Flow::faster && config.edge_map.buffers > 1),
          has_depth_buffers(config.inlier_unit.buffers > 1) {}
};

constexpr bool has_part(Parts const& parts, ModuleId id) {
    switch (id) {
        case ModuleId::edge_map_builder:
            return parts.flow == Flow::faster;
        case ModuleId::edge_map_output:
            return parts.has_map_buffers;
        case ModuleId::inlier_sweep:
            return parts.has_depth_buffers;
        default:
            return true;
    }
}

/// Between which modules a FIFO stands.
constexpr FifoEnds ends_of(Parts const& parts, FifoId id) {
    FifoEnds ends = fifo_ends[index_of(id)];
    bool const is_swept = id == FifoId::edge_map || id == FifoId::observed_depth || id == FifoId::observed_edge;
    if (parts.has_map_buffers && id == FifoId::edge_map)
        ends.writer = ModuleId::edge_map_output;
    if (parts.has_depth_buffers && is_swept)
        ends.reader = ModuleId::inlier_sweep;
    if (parts.has_depth_buffers && id == FifoId::result)
        ends.writer = ModuleId::inlier_sweep;
    return ends;
}
constexpr bool has_part(Parts const& parts, FifoId id) {
    bool const is_of_region = id == FifoId::region || id == FifoId::valid_depth;
    return has_part(parts, ends_of(parts, id).writer) && has_part(parts, ends_of(parts, id).reader) &&
           (parts.sweep_region == SweepRegion::touched || !is_of_region);
}

constexpr bool has_part(Parts const& parts, LoopId id) {
    bool const is_there = has_part(parts, loop_names[index_of(id)].module);
    switch (id) {
        case LoopId::output:
            return is_there && !parts.has_map_buffers;
        case LoopId::sweep:
            return is_there && !parts.has_depth_buffers;
        case LoopId::extract:
            return is_there && !parts.has_depth_buffers && parts.flow == Flow::fpga_grip;
        case LoopId::buffered_extract:
            return is_there && parts.flow == Flow::fpga_grip;
        default:
            return is_there;
    }
}

constexpr bool has_part(Parts const& parts, BramId id) {
    return parts.flow == Flow::faster || id == BramId::depth_buffer;
}

/// Numbers of the parts of one kind, in their order.
std::vector<std::size_t> modules_of(Parts const& parts);
std::vector<std::size_t> fifos_of(Parts const& parts);
std::vector<std::size_t> loops_of(Parts const& parts);
std::vector<std::size_t> brams_of(Parts const& parts);

/// Of the table of processes of a core: it ends with the last that is there, and keeps the places of others before it.
std::size_t process_places(Parts const& parts);

/// False for the keys of parts that are not there. `key`: dotted name.
bool applies_to(Parts const& parts, std::string const& key);
/// Of a key that does not apply: the key whose value takes its part away.
char const* key_that_decides(Parts const& parts, std::string const& key);

}  // namespace faster
