#pragma once
#include "datapath/edge_map/single_map.hpp"

namespace faster::datapath {

/// Thesis 5.3: as 5.2, and an object token makes an edge of the pixels above and below that no object token covers,
/// at once.
class BoundedMap final : public SingleMap<BoundedMap> {
  public:
    using SingleMap::SingleMap;

    void take_one(EdgeToken const& token) {
        if (token.kind != EdgeTokenKind::Object) {
            make_edge(token.row, token.col);
            return;
        }
        state(token.row, token.col) = no_edge;
        if (is_inside(token.row + 1))
            make_edge(token.row + 1, token.col);
        if (is_inside(token.row - 1))
            make_edge(token.row - 1, token.col);
    }
};

}  // namespace faster::datapath
