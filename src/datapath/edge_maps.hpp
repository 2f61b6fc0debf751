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
    /// between.
    void take_second(EdgeToken const& token) {
        object_.set(token.row, token.col);
        mark_uncovered(token.row + 1, token.col);
        mark_uncovered(token.row - 1, token.col);
    }

    /// Both iterations of each of the object tokens at columns [from, to] of a row, all inside the window. In any order:
    /// tokens of one row do not look at each other.
    void take_run(int row, int from, int to) {
        auto const clear = [](std::uint64_t& word, std::uint64_t mask, std::size_t) { word &= ~mask; };
        auto const set = [](std::uint64_t& word, std::uint64_t mask, std::size_t) { word |= mask; };
        auto const mark = [this](std::uint64_t& word, std::uint64_t mask, std::size_t at) {
            word |= mask & ~object_.word(at);
        };
        edge_.for_each_word(row, from, to, clear);
        object_.for_each_word(row, from, to, set);
        if (is_inside(row + 1))
            edge_.for_each_word(row + 1, from, to, mark);
        if (is_inside(row - 1))
            edge_.for_each_word(row - 1, from, to, mark);
    }

    Bitmap const& edge() const { return edge_; }
    Bitmap const& object() const { return object_; }

    bool covers(EdgeToken const& token) const { return is_inside(token.row) && is_inside(token.col); }

  private:
    bool is_inside(int coordinate) const { return static_cast<unsigned>(coordinate) < static_cast<unsigned>(window_); }
    void mark_uncovered(int row, int col) {
        if (is_inside(row) && !object_.test(row, col))
            edge_.set(row, col);
    }

    int window_;
    Bitmap edge_;
    Bitmap object_;
};

}  // namespace faster::datapath
