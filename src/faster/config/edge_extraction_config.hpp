#pragma once
#include "dataflow/base/cycles.hpp"
#include "faster/config/inlier_unit_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Edges of the finished depth buffer by thesis eq. 2.2, flow fpga_grip; keys `accelerator.edge_extraction.*`. Formats:
/// docs/modules/edge_extractor.md.
struct EdgeExtractionConfig {
    int neighbourhood = 5;            ///< side n of the n x n neighbourhood [px], odd, 3 to 15
    double threshold = 0.01;          ///< c(u, v) above it is an edge
    double focal_length_px = 570.34;  ///< of the camera the poses are rendered for
    NeighbourAccess neighbour_access = NeighbourAccess::window;
    Cycles square_root_latency = 28;  ///< stages of the square root unit
    Cycles divider_latency = 46;      ///< stages of the divider
};

}  // namespace faster
