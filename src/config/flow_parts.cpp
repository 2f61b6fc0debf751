#include "config/flow_parts.hpp"

#include <algorithm>

#include "config/key_names.hpp"

namespace faster {
namespace {

template <class Id> std::vector<std::size_t> parts_of(Flow flow, std::size_t count) {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < count; ++i) {
        if (has_part(flow, static_cast<Id>(i))) {
            parts.push_back(i);
        }
    }
    return parts;
}

template <class Id, class NameOfKey>
void add_absent(Flow flow, std::size_t count, NameOfKey name_of_key, std::vector<std::string>& beginnings) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!has_part(flow, static_cast<Id>(i))) {
            beginnings.push_back(name_of_key(static_cast<Id>(i), ""));
        }
    }
}

/// How the names of keys begin that belong to parts the flow does not have.
std::vector<std::string> absent_beginnings(Flow flow) {
    std::vector<std::string> beginnings;
    add_absent<FifoId>(flow, fifo_count, fifo_key_name, beginnings);
    add_absent<LoopId>(flow, loop_count, loop_key_name, beginnings);
    add_absent<BramId>(flow, bram_count, bram_key_name, beginnings);
    if (flow == Flow::faster) {
        beginnings.emplace_back("accelerator.edge_extraction.");
    } else {
        beginnings.emplace_back("accelerator.edge_map.");
        beginnings.emplace_back("accelerator.inlier_unit.neighbour_access");
        beginnings.emplace_back("accelerator.rasterizer.edge_tokens");
    }
    return beginnings;
}

}  // namespace

std::vector<std::size_t> modules_of(Flow flow) { return parts_of<ModuleId>(flow, module_count); }
std::vector<std::size_t> fifos_of(Flow flow) { return parts_of<FifoId>(flow, fifo_count); }
std::vector<std::size_t> loops_of(Flow flow) { return parts_of<LoopId>(flow, loop_count); }
std::vector<std::size_t> brams_of(Flow flow) { return parts_of<BramId>(flow, bram_count); }

bool applies_to(Flow flow, std::string const& key) {
    std::vector<std::string> const beginnings = absent_beginnings(flow);
    return std::none_of(beginnings.begin(), beginnings.end(),
                        [&key](std::string const& beginning) { return key.rfind(beginning, 0) == 0; });
}

}  // namespace faster
