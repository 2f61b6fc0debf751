#pragma once
#include "common/tokens.hpp"
#include "datapath/bitmap.hpp"

namespace faster::datapath {

/// Thesis A.2's two maps: which pixels the object covers, and which lie on its contour (SPEC section 2,
/// EdgeMapBuilder).
class EdgeMaps {
  public:
    explicit EdgeMaps(int window) : window_(window), edge_(window), object_(window) {}

    void clear() {
        edge_.clear();
        object_.clear();
    }

    /// True if the token needs a second iteration to write the object map and the neighbours' edges.
    bool needs_second(EdgeToken const& token) const { return token.kind == EdgeTokenKind::Object && covers(token); }

    /// The iteration that consumes a token.
    void take(EdgeToken const& token) {
        if (!covers(token))
            return;
        if (token.kind == EdgeTokenKind::Object)
            edge_.reset(token.row, token.col);
        else if (!object_.test(token.row, token.col))
            edge_.set(token.row, token.col);
    }

    /// The iteration after it, for the same token. What it looks at was read one iteration earlier; nothing wrote in
    /// between. A neighbour outside the window falls on the maps' guard rows.
    void take_second(EdgeToken const& token) {
        object_.set(token.row, token.col);
        mark_uncovered(token.row + 1, token.col);
        mark_uncovered(token.row - 1, token.col);
    }

    /// All iterations of a token inside the window: those of an object token one after the other, or the one of an edge
    /// token. Without a branch on the kind, which nobody can foretell.
    void take_whole(EdgeToken const& token) {
        std::ptrdiff_t const row = edge_.words_per_row();
        std::uint64_t const bit = std::uint64_t{1} << (token.col & 63);
        std::uint64_t const object_bit = token.kind == EdgeTokenKind::Object ? bit : 0;
        std::uint64_t* const edge = edge_.word_at(token.row, token.col);
        std::uint64_t* const object = object_.word_at(token.row, token.col);
        edge[0] = (edge[0] & ~object_bit) | (bit & ~object_bit & ~object[0]);
        object[0] |= object_bit;
        edge[row] |= object_bit & ~object[row];
        edge[-row] |= object_bit & ~object[-row];
    }

    Bitmap const& edge() const { return edge_; }
    Bitmap const& object() const { return object_; }

    bool covers(EdgeToken const& token) const { return is_inside(token.row) && is_inside(token.col); }

  private:
    bool is_inside(int coordinate) const { return static_cast<unsigned>(coordinate) < static_cast<unsigned>(window_); }
    void mark_uncovered(int row, int col) {
        if (!object_.test(row, col))
            edge_.set(row, col);
    }

    int window_;
    Bitmap edge_;
    Bitmap object_;
};

}  // namespace faster::datapath
