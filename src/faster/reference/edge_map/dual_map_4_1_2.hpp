#pragma once
#include <optional>
#include <utility>

#include "faster/reference/edge_map/transition.hpp"

namespace faster::reference {

/// Thesis 4.1.2: an object token is stored at once; edges above and below it, if they are to become any, by a second
/// iteration before the next token. After the end token that one only runs with flush_last.
class DualMapFirstWrite : public Transition {
  public:
    using Transition::Transition;

    void next_token() {
        set(std::exchange(edge_down_, std::nullopt));
        set(std::exchange(edge_up_, std::nullopt));
    }

    void object(int row, int col) {
        Transition::object(row, col);
        edge_down_ = uncovered(row + 1, col);
        edge_up_ = uncovered(row - 1, col);
    }

    void end(bool flush_last) {
        if (flush_last) {
            next_token();
        }
    }

  private:
    struct Pixel {
        int row = 0;
        int col = 0;
    };

    std::optional<Pixel> uncovered(int row, int col) const {
        if (!object_map_.contains(row, col) || object_map_.at(row, col) != 0) {
            return std::nullopt;
        }
        return Pixel{row, col};
    }
    void set(std::optional<Pixel> const& place) {
        if (place) {
            edge_map_.at(place->row, place->col) = 1;
        }
    }

    std::optional<Pixel> edge_up_;  // as in the thesis's pseudo code
    std::optional<Pixel> edge_down_;
};

}  // namespace faster::reference
