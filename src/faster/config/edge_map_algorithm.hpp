#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "dataflow/base/cycles.hpp"
#include "dataflow/base/enumerators.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// How the edge tokens of a sample become its edge map; key `accelerator.edge_map.algorithm`. The designs of the
/// thesis, in its order.
enum class EdgeMapAlgorithm {
    threshold,       ///< 5.1: pixels near an edge, seen once
    transition,      ///< 5.2: pixels where the scan enters and leaves a triangle
    bounded,         ///< 5.3: and those above and below a covered one, in one map
    dual_map,        ///< 5.4 and A.2: in two maps; an object token takes two iterations
    dual_map_4_1_2,  ///< 4.1.2: in two maps, with the object bit written in the first iteration
    inner_border,    ///< 7.2: covered pixels beside one that is not
};

/// One number for each of the two maps of the edge map builder.
struct PerMap {
    std::uint64_t edge_map = 0;
    std::uint64_t object_map = 0;
};

/// What an iteration does to a map, a bit each: to the pixel's own word, and to those below and above it.
namespace map_touch {
constexpr std::uint64_t read_own = 1;
constexpr std::uint64_t write_own = 2;
constexpr std::uint64_t read_vertical = 4;
constexpr std::uint64_t write_vertical = 8;
}  // namespace map_touch

/// What an edge map algorithm asks of the hardware: the memories it keeps, and what the branches of its loops access,
/// bits of map_touch each. Initiation intervals, dependences and the addresses of waveforms follow from these lines.
/// Source: thesis chapter 5, 4.1.2, 7.2 and A.2; docs/variants.md tells how each number comes about.
struct EdgeMapDesign {
    EdgeMapAlgorithm algorithm;
    bool contour_on_object;  ///< contour pixels are covered; otherwise they lie just outside
    PerMap bits;             ///< per pixel of the window; 0: there is no such map
    PerMap clear;            ///< what an iteration of edge_map_builder.clear does,
    PerMap output;           ///< one of .output,
    PerMap edge_token;       ///< and one of .token: that consumes an edge token of the window,
    PerMap object_token;     ///< an object token,
    PerMap second;           ///< or none, but finishes the object token before it
    /// Initiation interval of the token loop that reading after writing demands. Thesis 5.4: a write takes two cycles,
    /// so an iteration that may read what the one before wrote has to start two cycles after it. The designs with two
    /// maps declare that they do not (`dependence inter false`).
    Cycles token_recurrence;
};

constexpr std::array edge_map_designs{
    EdgeMapDesign{EdgeMapAlgorithm::threshold,
                  false,
                  {2, 0},
                  {map_touch::write_own, 0},
                  {map_touch::read_own, 0},
                  {map_touch::read_own | map_touch::write_own, 0},
                  {},
                  {},
                  2},
    EdgeMapDesign{EdgeMapAlgorithm::transition,
                  false,
                  {2, 0},
                  {map_touch::write_own, 0},
                  {map_touch::read_own, 0},
                  {map_touch::read_own | map_touch::write_own, 0},
                  {map_touch::write_own, 0},
                  {},
                  2},
    EdgeMapDesign{EdgeMapAlgorithm::bounded,
                  false,
                  {2, 0},
                  {map_touch::write_own, 0},
                  {map_touch::read_own, 0},
                  {map_touch::read_own | map_touch::write_own, 0},
                  {map_touch::write_own | map_touch::read_vertical | map_touch::write_vertical, 0},
                  {},
                  2},
    EdgeMapDesign{EdgeMapAlgorithm::dual_map,
                  false,
                  {1, 1},
                  {map_touch::write_own, map_touch::write_own},
                  {map_touch::read_own, 0},
                  {map_touch::write_own, map_touch::read_own},
                  {map_touch::write_own, map_touch::read_vertical},
                  {map_touch::write_vertical, map_touch::write_own},
                  1},
    EdgeMapDesign{EdgeMapAlgorithm::dual_map_4_1_2,
                  false,
                  {1, 1},
                  {map_touch::write_own, map_touch::write_own},
                  {map_touch::read_own, 0},
                  {map_touch::write_own, map_touch::read_own},
                  {map_touch::write_own, map_touch::read_vertical | map_touch::write_own},
                  {map_touch::write_vertical, 0},
                  1},
    EdgeMapDesign{EdgeMapAlgorithm::inner_border,
                  true,
                  {0, 1},
                  {0, map_touch::write_own},
                  {0, map_touch::read_own},
                  {},
                  {0, map_touch::write_own},
                  {},
                  1},
};
static_assert(has_a_row_for_each<EdgeMapAlgorithm>(edge_map_designs,
                                                   [](EdgeMapDesign const& row) { return row.algorithm; }),
              "every edge map algorithm has a row, in their order");

constexpr EdgeMapDesign const& design_of(EdgeMapAlgorithm algorithm) {
    return edge_map_designs[static_cast<std::size_t>(algorithm)];
}

/// Contour pixels lie on the object; otherwise just outside.
constexpr bool contour_is_on_object(EdgeMapAlgorithm algorithm) { return design_of(algorithm).contour_on_object; }

}  // namespace faster
