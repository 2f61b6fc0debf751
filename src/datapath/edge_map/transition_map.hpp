#pragma once
#include "datapath/edge_map/single_map.hpp"

namespace faster::datapath {

/// Thesis 5.2: an object token is no edge for good; an edge token is one unless an object token was there. Nothing
/// looks up or down, so contours along a row are missed.
class TransitionMap final : public SingleMap<TransitionMap> {
  public:
    using SingleMap::SingleMap;

    void take_one(EdgeToken const& token) {
        if (token.kind == EdgeTokenKind::Object)
            state(token.row, token.col) = no_edge;
        else
            make_edge(token.row, token.col);
    }
};

}  // namespace faster::datapath
