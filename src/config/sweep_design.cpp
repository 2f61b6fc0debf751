#include "config/sweep_design.hpp"

#include "config/edge_map_design.hpp"
#include "config/lane_rows.hpp"

namespace faster {
namespace {

AccessPattern const pixel{{{0, 0}}, {}};
AccessPattern const pixel_and_neighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0, 0}}, {}};

}  // namespace

SweepDesign sweep_design(AcceleratorConfig const& config, int window) {
    int const lanes = config.inlier_unit.sweep_lanes;
    // A pixel's last neighbour lies a row below: so long its own depth is needed, or has to be waited for.
    std::size_t const row_and_token = LaneRows(window, lanes).tokens_per_row() + 1;
    bool const clears = config.inlier_unit.clearing == MapClearing::on_read_out;
    bool const own_depth = contour_is_on_object(config.edge_map.algorithm);
    bool const reads_neighbours = !own_depth && config.inlier_unit.neighbour_access == NeighbourAccess::direct;
    AccessPattern one_pixel = reads_neighbours ? pixel_and_neighbours : pixel;
    if (clears)  // what has been read, or where nobody reads any more: a row above and a token to the left
        one_pixel.writes.push_back(reads_neighbours ? PixelOffset{-1, -lanes} : PixelOffset{0, 0});
    SweepDesign design;
    design.accesses = widened(one_pixel, lanes);
    design.has_line_buffers = !own_depth && !reads_neighbours;
    if (design.has_line_buffers)
        design.lead = row_and_token;
    if (clears && reads_neighbours)
        design.tail = row_and_token;
    return design;
}

}  // namespace faster
