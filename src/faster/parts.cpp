#include "faster/parts.hpp"

#include <algorithm>

#include "kernel/config/key_names.hpp"

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

/// A loop's keys are there with it, wherever it runs.
void add_absent_loops(Parts const& parts, std::vector<std::string>& beginnings) {
    std::vector<std::size_t> const loops = loops_of(parts);
    for (std::size_t i = 0; i < keyed_loop_count; ++i) {
        auto const is_timed_by_its_keys = [i](std::size_t loop) { return configured_as(LoopId{loop}) == LoopId{i}; };
        if (std::none_of(loops.begin(), loops.end(), is_timed_by_its_keys)) {
            beginnings.push_back(loop_key_name(LoopId{i}, ""));
        }
    }
}

/// How the names of keys begin that belong to parts that are not there.
std::vector<std::string> absent_beginnings(Parts const& parts) {
    std::vector<std::string> beginnings;
    add_absent<FifoId>(parts, fifo_count, fifo_key_name, beginnings);
    add_absent_loops(parts, beginnings);
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

std::size_t process_places(Parts const& parts) { return modules_of(parts).back() + 1; }

bool applies_to(Parts const& parts, std::string const& key) {
    std::vector<std::string> const beginnings = absent_beginnings(parts);
    return std::none_of(beginnings.begin(), beginnings.end(),
                        [&key](std::string const& beginning) { return key.rfind(beginning, 0) == 0; });
}

char const* key_that_decides(Parts const& parts, std::string const& key) {
    Parts with_region = parts;
    with_region.sweep_region = SweepRegion::touched;
    Parts with_map_buffers = parts;
    with_map_buffers.has_map_buffers = parts.flow == Flow::faster;
    Parts with_depth_buffers = parts;
    with_depth_buffers.has_depth_buffers = true;
    return applies_to(with_region, key)          ? "accelerator.inlier_unit.sweep_region"
           : applies_to(with_map_buffers, key)   ? "accelerator.edge_map.buffers"
           : applies_to(with_depth_buffers, key) ? "accelerator.inlier_unit.buffers"
                                                 : "accelerator.flow";
}

}  // namespace faster
