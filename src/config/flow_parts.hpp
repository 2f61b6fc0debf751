#pragma once
#include <string>
#include <vector>

#include "common/flow.hpp"
#include "config/machine.hpp"

namespace faster {

/// Which of the parts of machine.hpp the cores of a flow have. A core's tables of FIFOs and processes keep the places
/// of the others, which stay empty: a part's number is the same in every flow.
constexpr bool has_part(Flow flow, ModuleId id) { return flow == Flow::faster || id != ModuleId::edge_map_builder; }
constexpr bool has_part(Flow flow, FifoId id) {
    return has_part(flow, fifo_ends[index_of(id)].writer) && has_part(flow, fifo_ends[index_of(id)].reader);
}
constexpr bool has_part(Flow flow, LoopId id) {
    return has_part(flow, loop_names[index_of(id)].module) && (flow == Flow::fpga_grip || id != LoopId::extract);
}
constexpr bool has_part(Flow flow, BramId id) { return flow == Flow::faster || id == BramId::depth_buffer; }

/// Numbers of the parts of one kind, in their order.
std::vector<std::size_t> modules_of(Flow flow);
std::vector<std::size_t> fifos_of(Flow flow);
std::vector<std::size_t> loops_of(Flow flow);
std::vector<std::size_t> brams_of(Flow flow);

/// False for the keys of parts that a flow does not have. `key`: dotted name.
bool applies_to(Flow flow, std::string const& key);

}  // namespace faster
