#pragma once
#include <cstddef>

#include "dataflow/core/machine/access_pattern.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/edge_map_design.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What the sweep of the inlier unit asks of the depth buffer. docs/variants.md tells how the numbers come about.
struct SweepDesign {
    AccessPattern accesses;  ///< of an iteration
    bool has_line_buffers = false;
    bool clears_behind = false;  ///< what nobody reads any more: a row above and a token to the left

    /// Iterations before the first pixel is judged: the line buffers fill. A pixel's last neighbour lies a row below:
    /// so long its own depth is needed, or has to be waited for.
    std::size_t lead(std::size_t tokens_per_row) const { return has_line_buffers ? tokens_per_row + 1 : 0; }
    /// Iterations after the last.
    std::size_t tail(std::size_t tokens_per_row) const { return clears_behind ? tokens_per_row + 1 : 0; }
};

/// Contour pixels lie on the object, and so have a depth of their own; otherwise just outside.
constexpr bool contour_has_depth(AcceleratorConfig const& config) {
    return config.flow == Flow::fpga_grip || contour_is_on_object(config.edge_map.algorithm);
}

/// Pixels around the fragments of a sample, and around edge tokens that lie anywhere (thesis 5.1), that the sample can
/// have changed as well: contours beside the object reach one further.
constexpr int touched_margin(AcceleratorConfig const& config) {
    return contour_has_depth(config) || config.edge_map.algorithm == EdgeMapAlgorithm::threshold ? 0 : 1;
}

SweepDesign sweep_design(AcceleratorConfig const& config);

}  // namespace faster
