#pragma once
#include "faster/reference/edge_map/edge_map_builder.hpp"

namespace faster::reference {

/// Thesis 5.2: edge tokens that no object token names are contour.
class Transition : public EdgeMapBuilder {
  public:
    Transition(Image<std::uint8_t>& edge_map, Image<std::uint8_t>& object_map) : EdgeMapBuilder(edge_map, object_map) {}

    void next_token() {}
    void object(int row, int col) {
        object_map_.at(row, col) = 1;
        edge_map_.at(row, col) = 0;
    }
    void edge(int row, int col) {
        if (object_map_.at(row, col) == 0) {
            edge_map_.at(row, col) = 1;
        }
    }
    void end(bool /*flush_last*/) {}
};

}  // namespace faster::reference
