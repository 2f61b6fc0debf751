#include "config/parts.hpp"

#include <algorithm>

#include "config/key_names.hpp"

namespace faster {
namespace {

template <class Id> std::vector<std::size_t> numbers_of(Parts const& parts, std::size_t count) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        if (has_part(parts, static_cast<Id>(i))) {
            numbers.push_back(i);
        }
    }
    return numbers;
}

template <class Id, class NameOfKey>
void add_absent(Parts const& parts, std::size_t count, NameOfKey name_of_key, std::vector<std::string>& beginnings) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!has_part(parts, static_cast<Id>(i))) {
            beginnings.push_back(name_of_key(static_cast<Id>(i), ""));
        }
    }
}

/// How the names of keys begin that belong to parts that are not there.
std::vector<std::string> absent_beginnings(Parts const& parts) {
    std::vector<std::string> beginnings;
    add_absent<FifoId>(parts, fifo_count, fifo_key_name, beginnings);
    add_absent<LoopId>(parts, loop_count, loop_key_name, beginnings);
    add_absent<BramId>(parts, bram_count, bram_key_name, beginnings);
    if (parts.flow == Flow::faster) {
        beginnings.emplace_back("accelerator.edge_extraction.");
    } else {
        beginnings.emplace_back("accelerator.edge_map.");
        beginnings.emplace_back("accelerator.inlier_unit.neighbour_access");
        beginnings.emplace_back("accelerator.rasterizer.edge_tokens");
    }
    return beginnings;
}

}  // namespace

std::vector<std::size_t> modules_of(Parts const& parts) { return numbers_of<ModuleId>(parts, module_count); }
std::vector<std::size_t> fifos_of(Parts const& parts) { return numbers_of<FifoId>(parts, fifo_count); }
std::vector<std::size_t> loops_of(Parts const& parts) { return numbers_of<LoopId>(parts, loop_count); }
std::vector<std::size_t> brams_of(Parts const& parts) { return numbers_of<BramId>(parts, bram_count); }

bool applies_to(Parts const& parts, std::string const& key) {
    std::vector<std::string> const beginnings = absent_beginnings(parts);
    return std::none_of(beginnings.begin(), beginnings.end(),
                        [&key](std::string const& beginning) { return key.rfind(beginning, 0) == 0; });
}

}  // namespace faster
