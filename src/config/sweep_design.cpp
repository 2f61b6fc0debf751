#include "config/sweep_design.hpp"

#include "config/edge_map_design.hpp"

namespace faster {
namespace {

AccessPattern const pixel{{{0, 0}}, {}};
AccessPattern const pixel_and_neighbours{{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}, {}};

}  // namespace

SweepDesign sweep_design(AcceleratorConfig const& config, int window) {
    // A pixel's last neighbour lies a row below: so long its own depth is needed, or has to be waited for.
    auto const row_and_pixel = static_cast<std::size_t>(window) + 1;
    bool const clears = config.inlier_unit.clearing == MapClearing::on_read_out;
    bool const own_depth = contour_is_on_object(config.edge_map.algorithm);
    bool const reads_neighbours = !own_depth && config.inlier_unit.neighbour_access == NeighbourAccess::direct;
    SweepDesign design;
    design.accesses = reads_neighbours ? pixel_and_neighbours : pixel;
    design.has_line_buffers = !own_depth && !reads_neighbours;
    if (design.has_line_buffers)
        design.lead = row_and_pixel;
    if (clears && reads_neighbours)
        design.tail = row_and_pixel;
    if (clears)  // what has been read, or where nobody reads any more: a row above and a pixel to the left
        design.accesses.writes.push_back(reads_neighbours ? PixelOffset{-1, -1} : PixelOffset{0, 0});
    return design;
}

}  // namespace faster
