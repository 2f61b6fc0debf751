#pragma once
#include "modules/edge_map_builder/algorithms/single_map.hpp"

namespace faster::datapath {

/// Thesis 5.2: an object token is no edge for good; an edge token is one unless an object token was there. Nothing
/// looks up or down, so contours along a row are missed.
class TransitionMap final : public SingleMap<TransitionMap> {
  public:
    using SingleMap::SingleMap;

    template <class Watch> void take_one(EdgeToken const& token, Watch const& watch) {
        if (token.kind == EdgeTokenKind::Object)
            write(token.row, token.col, no_edge, watch);
        else
            make_edge(token.row, token.col, watch);
    }
};

}  // namespace faster::datapath
