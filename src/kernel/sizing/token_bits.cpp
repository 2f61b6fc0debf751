#include "kernel/sizing/token_bits.hpp"

#include "faster/parts.hpp"

namespace faster::sizing {

namespace {

constexpr unsigned vertex_xy_bits = 16;
constexpr unsigned vertex_z_bits = 16;
constexpr unsigned depth_bits = 11;
constexpr unsigned header_bits = 4 * 32;    // sample, centre_row, centre_col, triangles
constexpr unsigned valid_raster_bits = 32;  // counts redraws
constexpr unsigned buffer_bits = 1;
constexpr unsigned pixel_bits = 2 * 16;  // row and column relative to the window, which may lie outside it
/// A triangle's doubled area is no more than its bounding box: x range times y range, both below 2^16.
constexpr unsigned magnitude_of_area = 2 * vertex_xy_bits;

constexpr unsigned bits_for(std::uint64_t largest) {
    unsigned bits = 0;
    for (; largest > 0; largest /= 2)
        ++bits;
    return bits;
}

/// Of a pixel of the window, or of -1 twice, which says that a region has none.
unsigned corner_bits(AcceleratorConfig const& config) {
    return 2 * (bits_for(static_cast<std::uint64_t>(config.window)) + 1);
}

/// What a full buffer's token says of its region.
unsigned region_bits(AcceleratorConfig const& config) {
    return config.inlier_unit.sweep_region == SweepRegion::touched ? 2 * corner_bits(config) : 0;
}

/// Four counters count pixels of the window once; valid_raster counts redraws too.
unsigned result_bits(AcceleratorConfig const& config) {
    auto const side = static_cast<std::uint64_t>(config.window);
    return 4 * bits_for(side * side) + valid_raster_bits;
}

/// Of a z sum: weights of a point inside add up to the area. Groups have their first column's, which modulo 2^48 is
/// enough for the covered ones, and what a column adds: signed, an extent of the triangle times one of its depths.
unsigned fragment_depth_bits(bool in_groups) {
    constexpr unsigned z_sum_bits = magnitude_of_area + vertex_z_bits;
    constexpr unsigned column_step_bits = vertex_xy_bits + vertex_z_bits + 1;
    return in_groups ? z_sum_bits + column_step_bits : z_sum_bits;
}

}  // namespace

unsigned token_bits(FifoId id, AcceleratorConfig const& config) {
    if (!has_part(Parts(config), id))
        return 0;
    bool const in_groups = config.rasterizer.lanes > 1;
    unsigned const mask_bits = in_groups ? static_cast<unsigned>(config.rasterizer.lanes) : 0;
    auto const lanes = static_cast<unsigned>(config.inlier_unit.sweep_lanes);
    switch (id) {
        case FifoId::sample_vertex:
        case FifoId::sample_raster:
        case FifoId::sample_observation:
            return header_bits;
        case FifoId::vertex:
            return 2 * vertex_xy_bits + vertex_z_bits;
        case FifoId::area:
            return magnitude_of_area + 1;  // signed
        case FifoId::area_reciprocal:      // up to 2^(recip + 2 xy), that of an area of code 1
            return static_cast<unsigned>(config.fraction_bits.area_reciprocal + 2 * config.fraction_bits.vertex_xy) + 1;
        case FifoId::command:
            return 2;
        case FifoId::fragment_depth:
            return fragment_depth_bits(in_groups);
        case FifoId::fragment_index:
            return pixel_bits + mask_bits;
        case FifoId::edge_token:
            return pixel_bits + (in_groups ? mask_bits : 2);  // an empty mask is the end; edge, object or end
        case FifoId::observed_depth:
            return depth_bits * lanes;
        case FifoId::edge_map:
        case FifoId::observed_edge:
            return lanes;
        case FifoId::region:
            return corner_bits(config);
        case FifoId::valid_depth:
            return bits_for(static_cast<std::uint64_t>(config.window) * static_cast<std::uint64_t>(config.window));
        case FifoId::map_full:
            return buffer_bits + region_bits(config);
        case FifoId::map_free:
        case FifoId::depth_free:
            return buffer_bits;
        case FifoId::depth_full:
            return buffer_bits + valid_raster_bits + region_bits(config);
        case FifoId::result:
            break;
    }
    return result_bits(config);
}

}  // namespace faster::sizing
