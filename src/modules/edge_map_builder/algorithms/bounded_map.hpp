#pragma once
#include "modules/edge_map_builder/algorithms/single_map.hpp"

namespace faster::datapath {

/// Thesis 5.3: an edge token makes an edge unless an object token was there (TransitionMap); an object token is no edge
/// for good, and at once makes edges of the pixels above and below that no object token covers.
class BoundedMap final : public SingleMap<BoundedMap> {
  public:
    using SingleMap::SingleMap;

    template <class Watch> void take_one(EdgeToken const& token, Watch const& watch) {
        if (token.kind != EdgeTokenKind::Object) {
            make_edge(token.row, token.col, watch);
            return;
        }
        write(token.row, token.col, no_edge, watch);
        if (is_inside(token.row + 1))
            make_edge(token.row + 1, token.col, watch);
        if (is_inside(token.row - 1))
            make_edge(token.row - 1, token.col, watch);
    }
};

}  // namespace faster::datapath
