#pragma once
#include "faster/config/edge_map_design.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/loop_branches.hpp"

namespace faster {

/// Bits of map_touch as words, seen from the pixel of an iteration that works on `lanes` of a row.
inline AccessPattern touched_words(std::uint64_t touches, int lanes) {
    constexpr PixelOffset own{0, 0};
    constexpr PixelOffset below{1, 0};
    constexpr PixelOffset above{-1, 0};
    AccessPattern pattern;
    if ((touches & map_touch::read_own) != 0)
        pattern.reads.push_back(own);
    if ((touches & map_touch::read_vertical) != 0)
        pattern.reads.insert(pattern.reads.end(), {below, above});
    if ((touches & map_touch::write_own) != 0)
        pattern.writes.push_back(own);
    if ((touches & map_touch::write_vertical) != 0)
        pattern.writes.insert(pattern.writes.end(), {below, above});
    return widened(pattern, lanes);
}

/// What an iteration of a loop without branches does to the maps.
inline LoopDescription& touch_maps(LoopDescription& loop, PerMap const& touches, int lanes = 1) {
    loop.accesses.clear();
    add_branches(loop, "edge_map", {touched_words(touches.edge_map, lanes)});
    return add_branches(loop, "object_map", {touched_words(touches.object_map, lanes)});
}

/// What the branches of the token loop do. A read takes a cycle, and what is written depends on it.
inline LoopDescription& add_token_branches(LoopDescription& loop, EdgeMapDesign const& design, int lanes = 1) {
    constexpr AccessStages stages{2, 3};
    auto const branches = [&](std::uint64_t PerMap::*map) {
        return std::vector{touched_words(design.edge_token.*map, lanes), touched_words(design.object_token.*map, lanes),
                           touched_words(design.second.*map, lanes)};
    };
    loop.accesses.clear();
    loop.memory_stages.clear();
    add_branches(loop, "edge_map", branches(&PerMap::edge_map), stages);
    return add_branches(loop, "object_map", branches(&PerMap::object_map), stages)
        .recurs_every(design.token_recurrence);
}

}  // namespace faster
