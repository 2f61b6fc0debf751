#pragma once
#include "faster/reference/edge_map/edge_map_builder.hpp"

namespace faster::reference {

/// Thesis 5.4 and A.2, the default (docs/function.md#edgemapbuilder). An object token takes two iterations: the first
/// clears its edge bit and looks at the pixels above and below, the second sets bits. The second runs before the next
/// token is looked at, wherever that token lies: so every token, also one outside the window, is announced by
/// next_token().
class DualMap : public EdgeMapBuilder {
  public:
    using EdgeMapBuilder::EdgeMapBuilder;

    void next_token() {
        if (!second_due_) {
            return;
        }
        second_due_ = false;
        object_map_.at(due_row_, due_col_) = 1;
        if (above_due_) {
            edge_map_.at(due_row_ - 1, due_col_) = 1;
        }
        if (below_due_) {
            edge_map_.at(due_row_ + 1, due_col_) = 1;
        }
    }

    void object(int row, int col) {
        edge_map_.at(row, col) = 0;
        below_due_ = row != object_map_.height() - 1 && object_map_.at(row + 1, col) == 0;
        above_due_ = row != 0 && object_map_.at(row - 1, col) == 0;
        due_row_ = row;
        due_col_ = col;
        second_due_ = true;
    }

    void edge(int row, int col) {
        if (object_map_.at(row, col) == 0) {
            edge_map_.at(row, col) = 1;
        }
    }

    /// A.2 leaves its loop at the end token, and with it a second iteration still due, unless `flush_last`.
    void end(bool flush_last) {
        if (flush_last) {
            next_token();
        }
    }

  private:
    bool second_due_ = false;
    bool above_due_ = false;
    bool below_due_ = false;
    int due_row_ = 0;
    int due_col_ = 0;
};

}  // namespace faster::reference
