#pragma once
#include "modules/edge_map_builder/algorithms/single_map.hpp"

namespace faster::datapath {

/// Thesis 5.1: tokens are pixels near an edge of a triangle. One triangle's edge is a contour; what a second triangle
/// sends as well lies between them, and is none.
class ThresholdMap final : public SingleMap<ThresholdMap> {
  public:
    using SingleMap::SingleMap;

    template <class Watch> void take_one(EdgeToken const& token, Watch const& watch) {
        std::uint8_t const seen = read(token.row, token.col, watch);
        write(token.row, token.col, seen == unknown ? is_edge : no_edge, watch);
    }
};

}  // namespace faster::datapath
