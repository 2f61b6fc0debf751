#pragma once
#include "faster/reference/edge_map/edge_map_builder.hpp"

namespace faster::reference {

/// Thesis 5.1: a pixel that one token names is contour; one that several name lies between triangles.
class Threshold : public EdgeMapBuilder {
  public:
    using EdgeMapBuilder::EdgeMapBuilder;

    void object(int row, int col) { edge(row, col); }
    void edge(int row, int col) {
        bool const is_new = edge_map_.at(row, col) == 0 && object_map_.at(row, col) == 0;
        edge_map_.at(row, col) = is_new ? 1 : 0;
        object_map_.at(row, col) = is_new ? 0 : 1;
    }
};

}  // namespace faster::reference
