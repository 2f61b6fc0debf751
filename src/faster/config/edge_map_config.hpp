#pragma once
#include <array>

#include "faster/config/edge_map_algorithm.hpp"
#include "faster/config/map_clearing.hpp"

namespace faster {

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
