#include "faster/config/sweep_design.hpp"

#include "faster/config/edge_map_design.hpp"

namespace faster {
namespace {

AccessPattern const pixel{{{0, 0}}, {}};
AccessPattern const pixel_and_neighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0, 0}}, {}};

}  // namespace

SweepDesign sweep_design(AcceleratorConfig const& config) {
    int const lanes = config.inlier_unit.sweep_lanes;
    bool const clears = config.inlier_unit.clearing == MapClearing::on_read_out;
    bool const own_depth = contour_has_depth(config);
    bool const reads_neighbours = !own_depth && config.inlier_unit.neighbour_access == NeighbourAccess::direct;
    AccessPattern one_pixel = reads_neighbours ? pixel_and_neighbours : pixel;
    if (clears)  // what has been read, or where nobody reads any more: a row above and a token to the left
        one_pixel.writes.push_back(reads_neighbours ? PixelOffset{-1, -lanes} : PixelOffset{0, 0});
    SweepDesign design;
    design.accesses = widened(one_pixel, lanes);
    design.has_line_buffers = !own_depth && !reads_neighbours;
    design.clears_behind = clears && reads_neighbours;
    return design;
}

}  // namespace faster
