#pragma once
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"

namespace faster::testing {

/// Wires of a token of each FIFO, added up from the formats of docs/function.md#formats and what the token says: the
/// tests' own table, for the twin's FIFOs. Where a configuration does not have the FIFO, as if it had.
inline unsigned token_bits(FifoId id, AcceleratorConfig const& config) {
    auto const digits = [](unsigned long long most) {
        unsigned bits = 0;
        while ((1ULL << bits) <= most)
            ++bits;
        return bits;
    };
    auto const side = static_cast<unsigned long long>(config.window);
    unsigned const pixels = digits(side * side);     // a count of them
    unsigned const corner = 2 * (digits(side) + 1);  // or -1
    unsigned const box = config.inlier_unit.sweep_region == SweepRegion::touched ? 2 * corner : 0;
    auto const side_by_side = static_cast<unsigned>(config.inlier_unit.sweep_lanes);
    bool const in_groups = config.rasterizer.lanes > 1;
    unsigned const mask = in_groups ? static_cast<unsigned>(config.rasterizer.lanes) : 0;
    if (id == FifoId::sample_vertex || id == FifoId::sample_raster || id == FifoId::sample_observation)
        return 4 * 32;
    if (id == FifoId::vertex)
        return 3 * 16;
    if (id == FifoId::area)
        return 1 + 16 + 16;
    if (id == FifoId::area_reciprocal)  // 2^(recip + 2 xy)
        return static_cast<unsigned>(config.fraction_bits.area_reciprocal + 2 * config.fraction_bits.vertex_xy + 1);
    if (id == FifoId::command)
        return 2;
    if (id == FifoId::fragment_depth)
        return 32 + 16 + (in_groups ? 1 + 16 + 16 : 0);
    if (id == FifoId::fragment_index)
        return 2 * 16 + mask;
    if (id == FifoId::edge_token)
        return 2 * 16 + (in_groups ? mask : 2);
    if (id == FifoId::edge_map || id == FifoId::observed_edge)
        return side_by_side;
    if (id == FifoId::observed_depth)
        return 11 * side_by_side;
    if (id == FifoId::result)
        return 4 * pixels + 32;
    if (id == FifoId::region)
        return corner;
    if (id == FifoId::valid_depth)
        return pixels;
    if (id == FifoId::map_full)
        return 1 + box;
    if (id == FifoId::depth_full)
        return 1 + 32 + box;
    return 1;  // map_free, depth_free
}

}  // namespace faster::testing
