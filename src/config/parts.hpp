#pragma once
#include <string>
#include <vector>

#include "config/accelerator_config.hpp"

namespace faster {

/// What of a configuration decides which of the parts of machine.hpp its cores have. A part's number is the same
/// whatever parts there are.
struct Parts {
    Flow flow = Flow::faster;

    constexpr Parts() = default;
    constexpr Parts(Flow its_flow) : flow(its_flow) {}
    explicit Parts(AcceleratorConfig const& config) : flow(config.flow) {}
};

constexpr bool has_part(Parts const& parts, ModuleId id) {
    return parts.flow == Flow::faster || id != ModuleId::edge_map_builder;
}
constexpr FifoEnds ends_of(Parts const&, FifoId id) { return fifo_ends[index_of(id)]; }
constexpr bool has_part(Parts const& parts, FifoId id) {
    return has_part(parts, ends_of(parts, id).writer) && has_part(parts, ends_of(parts, id).reader);
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
