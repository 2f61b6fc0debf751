#pragma once
#include <array>

#include "faster/config/map_clearing.hpp"

namespace faster {

/// How the edge tokens of a sample become its edge map; key `accelerator.edge_map.algorithm`. The designs of the
/// thesis, in its order.
enum class EdgeMapAlgorithm {
    threshold,       ///< 5.1: pixels near an edge, seen once
    transition,      ///< 5.2: pixels where the scan enters and leaves a triangle
    bounded,         ///< 5.3: and those above and below a covered one, in one map
    dual_map,        ///< 5.4 and A.2: the same in two maps; an object token takes two iterations
    dual_map_4_1_2,  ///< 4.1.2: the same, with the object bit written in the first iteration
    inner_border,    ///< 7.2: covered pixels beside one that is not
};

/// How contours are found; keys `accelerator.edge_map.*`.
struct EdgeMapConfig {
    EdgeMapAlgorithm algorithm = EdgeMapAlgorithm::dual_map;
    MapClearing clearing = MapClearing::loop;  ///< of both maps
    int buffers = 1;                           ///< of both maps, 1 or 2; 2: one is read out by a process of its own
    bool flush_last = false;                   ///< run a second iteration of the last token even after the end token
    /// Algorithm `threshold`: how far from zero an edge value w0, w1, w2 may be, >= 0 [px^2]
    std::array<double, 3> thresholds = {12, 12, 12};
};

}  // namespace faster
