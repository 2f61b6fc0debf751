#pragma once
#include "faster/reference/edge_map/edge_map_builder.hpp"

namespace faster::reference {

/// Thesis 5.2: edge tokens that no object token names are contour.
class Transition : public EdgeMapBuilder {
  public:
    using EdgeMapBuilder::EdgeMapBuilder;

    void object(int row, int col) {
        object_map_.at(row, col) = 1;
        edge_map_.at(row, col) = 0;
    }
    void edge(int row, int col) {
        if (object_map_.at(row, col) == 0) {
            edge_map_.at(row, col) = 1;
        }
    }
};

}  // namespace faster::reference
