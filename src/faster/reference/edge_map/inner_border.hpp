#pragma once
#include "faster/reference/edge_map/edge_map_builder.hpp"

namespace faster::reference {

/// Thesis 7.2: the contour is made of the covered pixels with an uncovered one below, above, right or left of them.
/// What lies outside the window is not known to be uncovered.
class InnerBorder : public EdgeMapBuilder {
  public:
    using EdgeMapBuilder::EdgeMapBuilder;

    void object(int row, int col) { object_map_.at(row, col) = 1; }
    void end(bool /*flush_last*/) {
        for (int row = 0; row < edge_map_.height(); ++row) {
            for (int col = 0; col < edge_map_.width(); ++col) {
                if (object_map_.at(row, col) == 0) {
                    mark_covered_neighbours(row, col);
                }
            }
        }
    }

  private:
    void mark_covered_neighbours(int row, int col) {
        mark_if_covered(row + 1, col);
        mark_if_covered(row - 1, col);
        mark_if_covered(row, col + 1);
        mark_if_covered(row, col - 1);
    }
    void mark_if_covered(int row, int col) {
        if (object_map_.contains(row, col) && object_map_.at(row, col) != 0) {
            edge_map_.at(row, col) = 1;
        }
    }
};

}  // namespace faster::reference
