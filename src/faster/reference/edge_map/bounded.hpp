#pragma once
#include "faster/reference/edge_map/transition.hpp"

namespace faster::reference {

/// Thesis 5.3: what lies above and below an object token counts as an edge token too.
class Bounded : public Transition {
  public:
    using Transition::Transition;

    void object(int row, int col) {
        Transition::object(row, col);
        if (edge_map_.contains(row + 1, col)) {
            edge(row + 1, col);
        }
        if (edge_map_.contains(row - 1, col)) {
            edge(row - 1, col);
        }
    }
};

}  // namespace faster::reference
