#pragma once
#include <array>
#include <cstdint>

#include "dataflow/base/cycles.hpp"
#include "faster/config/edge_map_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// One number for each of the two maps of the edge map builder.
struct PerMap {
    std::uint64_t edge_map = 0;
    std::uint64_t object_map = 0;
};

/// What an iteration does to a map, a bit each: to the pixel's own word, and to those above and below it.
namespace map_touch {
constexpr std::uint64_t read_own = 1;
constexpr std::uint64_t write_own = 2;
constexpr std::uint64_t read_vertical = 4;
constexpr std::uint64_t write_vertical = 8;
}  // namespace map_touch

/// What an edge map algorithm asks of the hardware: the memories it keeps, and what an iteration does to them in its
/// worst branch, reads and writes alike, as a static schedule has to provide for it. Source: thesis chapter 5, 4.1.2,
/// 7.2 and A.2; docs/variants.md tells how each number comes about.
struct EdgeMapDesign {
    PerMap bits;    ///< per pixel of the window; 0: there is no such map
    PerMap clear;   ///< bits of map_touch of an iteration of edge_map_builder.clear,
    PerMap token;   ///< .token
    PerMap output;  ///< and .output
    /// Words that an iteration of the token loop reads and writes at most, in whichever branch: the branch that a
    /// schedule has to provide for need not be the one that writes.
    PerMap token_reads;
    PerMap token_writes;
    /// Initiation interval of the token loop that reading after writing demands. Thesis 5.4: a write takes two cycles,
    /// so an iteration that may read what the one before wrote has to start two cycles after it. The designs with two
    /// maps declare that they do not (`dependence inter false`).
    Cycles token_recurrence;
};

/// In the order of EdgeMapAlgorithm.
constexpr std::array<EdgeMapDesign, 6> edge_map_designs{{
    // threshold: reads a state and writes the next
    {{2, 0},
     {map_touch::write_own, 0},
     {map_touch::read_own | map_touch::write_own, 0},
     {map_touch::read_own, 0},
     {1, 0},
     {1, 0},
     2},
    // transition: an edge token reads and writes
    {{2, 0},
     {map_touch::write_own, 0},
     {map_touch::read_own | map_touch::write_own, 0},
     {map_touch::read_own, 0},
     {1, 0},
     {1, 0},
     2},
    // bounded: an object token writes, and reads and writes above and below
    {{2, 0},
     {map_touch::write_own, 0},
     {map_touch::write_own | map_touch::read_vertical | map_touch::write_vertical, 0},
     {map_touch::read_own, 0},
     {2, 0},
     {3, 0},
     2},
    // dual_map: docs/timing-model.md#initiation-interval
    {{1, 1},
     {map_touch::write_own, map_touch::write_own},
     {map_touch::write_vertical, map_touch::read_vertical},
     {map_touch::read_own, 0},
     {0, 2},
     {2, 1},
     1},
    // dual_map_4_1_2: an object token writes its bit and reads two
    {{1, 1},
     {map_touch::write_own, map_touch::write_own},
     {map_touch::write_vertical, map_touch::write_own | map_touch::read_vertical},
     {map_touch::read_own, 0},
     {0, 2},
     {2, 1},
     1},
    // inner_border: an object token writes its bit
    {{0, 1}, {0, map_touch::write_own}, {0, map_touch::write_own}, {0, map_touch::read_own}, {0, 0}, {0, 1}, 1},
}};

constexpr EdgeMapDesign const& design_of(EdgeMapAlgorithm algorithm) {
    return edge_map_designs[static_cast<std::size_t>(algorithm)];
}

/// bits of map_touch of an iteration of edge_map_builder.output. Where it clears the maps, it writes a word of each.
constexpr PerMap output_touches(EdgeMapConfig const& config) {
    EdgeMapDesign const& design = design_of(config.algorithm);
    PerMap touches = design.output;
    if (config.clearing == MapClearing::on_read_out) {
        touches.edge_map |= design.bits.edge_map > 0 ? map_touch::write_own : 0;
        touches.object_map |= design.bits.object_map > 0 ? map_touch::write_own : 0;
    }
    return touches;
}

/// Contour pixels lie on the object; otherwise just outside.
constexpr bool contour_is_on_object(EdgeMapAlgorithm algorithm) { return algorithm == EdgeMapAlgorithm::inner_border; }

}  // namespace faster
