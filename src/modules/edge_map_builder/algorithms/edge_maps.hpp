#pragma once
#include <cstdint>
#include <vector>

#include "faster/data/tokens.hpp"
#include "modules/edge_map_builder/algorithms/map_watch.hpp"
#include "modules/edge_map_builder/algorithms/token_marks.hpp"

namespace faster::datapath {

/// Thesis A.2's two maps: which pixels the object covers, and which lie on its contour
/// (docs/function.md#edgemapbuilder). A byte per pixel, 0 or 1, row by row.
class EdgeMaps {
  public:
    explicit EdgeMaps(int window);

    void clear();

    /// True if the token needs a second iteration to write the object map and the neighbours' edges.
    bool needs_second(EdgeToken const& token) const { return token.kind == EdgeTokenKind::Object && covers(token); }

    /// The iteration that consumes a token.
    void take(EdgeToken const& token, MapWatch const& watch = {});

    /// The iteration after it, for the same token. What it looks at was read one iteration earlier; nothing wrote in
    /// between.
    void take_second(EdgeToken const& token, MapWatch const& watch = {});

    /// All iterations of a token: both of an object token, the one of an edge token. For hot loops: it only marks what
    /// the token says, as the order of tokens does not matter. Whether the edge or the object token of a pixel comes
    /// first, the pixel is object and no edge in the end. What follows for the edge map is left to settle(). 1 if the
    /// token took two iterations.
    std::uint32_t mark(EdgeToken const& token) {
        static_assert(static_cast<int>(EdgeTokenKind::Object) == 1, "the kind serves as an index");
        if (!covers(token))
            return 0;
        auto const is_object = static_cast<std::uint32_t>(token.kind) & 1U;
        map_[is_object][index(token.row, token.col)] = 1;
        return is_object;
    }

    /// Where mark() marks tokens, for those who have many.
    TokenMarks marks() { return {map_[0] + side_, map_[1] + side_}; }

    /// Makes the edge map what it is after all tokens marked since clear(), before anything else looks at the maps.
    void settle();

    std::uint8_t const* edge() const { return map_[0] + side_; }
    std::uint8_t const* object() const { return map_[1] + side_; }
    int side() const { return static_cast<int>(side_); }

  private:
    bool covers(EdgeToken const& token) const { return is_inside(token.row) && is_inside(token.col); }
    bool is_inside(int coordinate) const { return static_cast<unsigned>(coordinate) < side_; }
    /// The first row guards the map above, another one below.
    std::size_t index(int row, int col) const {
        return static_cast<std::size_t>(row + 1) * side_ + static_cast<std::size_t>(col);
    }
    /// The number of a pixel's word, without guards.
    std::size_t word(int row, int col) const { return index(row, col) - side_; }
    void mark_uncovered(int row, int col, MapWatch const& watch);

    unsigned side_;
    std::vector<std::uint8_t> bytes_;
    std::uint8_t* map_[2];  ///< by kind of token: contour, object
};

}  // namespace faster::datapath
