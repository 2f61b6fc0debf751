#pragma once
#include <cstddef>
#include <cstdint>

#include "config/accelerator_config.hpp"
#include "config/edge_map_design.hpp"

namespace faster {

/// What the sweep of the inlier unit asks of the depth buffer. docs/timing-model.md tells how the numbers come about.
struct SweepDesign {
    std::uint64_t reads = 5;   ///< per iteration
    std::uint64_t writes = 0;  ///< per iteration
    std::size_t lead = 0;      ///< iterations before the first pixel is judged: the line buffers fill
    std::size_t tail = 0;      ///< iterations after the last: what nobody reads any more is cleared
    bool has_line_buffers = false;
};

/// Contour pixels lie on the object, and so have a depth of their own; otherwise just outside.
constexpr bool contour_has_depth(AcceleratorConfig const& config) {
    return config.flow == Flow::fpga_grip || contour_is_on_object(config.edge_map.algorithm);
}

/// `window`: side of the window [px], which a stimulus trace decides.
inline SweepDesign sweep_design(AcceleratorConfig const& config, int window) {
    // A pixel's last neighbour lies a row below: so long its own depth is needed, or has to be waited for.
    auto const row_and_pixel = static_cast<std::size_t>(window) + 1;
    bool const clears = config.inlier_unit.clearing == MapClearing::on_read_out;
    bool const own_depth = contour_has_depth(config);
    SweepDesign design;
    design.reads = own_depth ? 1 : design_of(config.edge_map.algorithm).sweep_reads;
    design.writes = clears ? 1 : 0;
    design.has_line_buffers = !own_depth && config.inlier_unit.neighbour_access == NeighbourAccess::window;
    if (design.has_line_buffers) {
        design.reads = 1;
        design.lead = row_and_pixel;
    } else if (clears && !own_depth) {
        design.tail = row_and_pixel;
    }
    return design;
}

}  // namespace faster
