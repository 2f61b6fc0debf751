#pragma once
#include "faster/config/edge_map_config.hpp"

namespace faster {

/// What an iteration of edge_map_builder.output does to the maps, in bits of map_touch. Where it clears them, it writes
/// a word of each.
constexpr PerMap output_touches(EdgeMapConfig const& config) {
    EdgeMapDesign const& design = design_of(config.algorithm);
    PerMap touches = design.output;
    if (config.clearing == MapClearing::on_read_out) {
        touches.edge_map |= design.bits.edge_map > 0 ? map_touch::write_own : 0;
        touches.object_map |= design.bits.object_map > 0 ? map_touch::write_own : 0;
    }
    return touches;
}

}  // namespace faster
