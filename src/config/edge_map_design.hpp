#pragma once
#include <array>
#include <cstdint>

#include "common/cycles.hpp"
#include "common/edge_map_config.hpp"

namespace faster {

/// One number for each of the two maps of the edge map builder.
struct PerMap {
    std::uint64_t edge_map = 0;
    std::uint64_t object_map = 0;
};

/// What an edge map algorithm asks of the hardware: the memories it keeps, and what an iteration does to them in its
/// worst branch, reads and writes alike, as a static schedule has to provide for it. Source: thesis chapter 5, 4.1.2,
/// 7.2 and A.2; docs/timing-model.md tells how each number comes about.
struct EdgeMapDesign {
    PerMap bits;    ///< per pixel of the window; 0: there is no such map
    PerMap clear;   ///< accesses per iteration of edge_map_builder.clear,
    PerMap token;   ///< .token
    PerMap output;  ///< and .output
    /// Initiation interval of the token loop that reading after writing demands. Thesis 5.4: a write takes two cycles,
    /// so an iteration that may read what the one before wrote has to start two cycles after it. The designs with two
    /// maps declare that they do not (`dependence inter false`).
    Cycles token_recurrence;
    /// Accesses to depth_buffer per iteration of inlier_unit.sweep: the pixel, and the four around it unless contour
    /// pixels have a depth of their own.
    std::uint64_t sweep_reads;
};

/// In the order of EdgeMapAlgorithm.
constexpr std::array<EdgeMapDesign, 6> edge_map_designs{{
    {{2, 0}, {1, 0}, {2, 0}, {1, 0}, 2, 5},  // threshold: reads a state and writes the next
    {{2, 0}, {1, 0}, {2, 0}, {1, 0}, 2, 5},  // transition: an edge token reads and writes
    {{2, 0}, {1, 0}, {5, 0}, {1, 0}, 2, 5},  // bounded: an object token writes, and reads and writes above and below
    {{1, 1}, {1, 1}, {2, 2}, {1, 0}, 1, 5},  // dual_map: SPEC section 3
    {{1, 1}, {1, 1}, {2, 3}, {1, 0}, 1, 5},  // dual_map_4_1_2: an object token writes its bit and reads two
    {{0, 1}, {0, 1}, {0, 1}, {0, 1}, 1, 1},  // inner_border: an object token writes its bit
}};

constexpr EdgeMapDesign const& design_of(EdgeMapAlgorithm algorithm) {
    return edge_map_designs[static_cast<std::size_t>(algorithm)];
}

/// Accesses per iteration of edge_map_builder.output. Where it clears the maps, it writes a word of each.
constexpr PerMap output_accesses(EdgeMapConfig const& config) {
    EdgeMapDesign const& design = design_of(config.algorithm);
    PerMap accesses = design.output;
    if (config.clearing == MapClearing::on_read_out) {
        accesses.edge_map += design.bits.edge_map > 0 ? 1 : 0;
        accesses.object_map += design.bits.object_map > 0 ? 1 : 0;
    }
    return accesses;
}

/// Contour pixels lie on the object; otherwise just outside.
constexpr bool contour_is_on_object(EdgeMapAlgorithm algorithm) { return algorithm == EdgeMapAlgorithm::inner_border; }

}  // namespace faster
