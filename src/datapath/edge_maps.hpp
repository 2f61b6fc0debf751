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

    /// All iterations of many tokens, one after the other: both of an object token, the one of an edge token. For hot
    /// loops: tokens of one row and word are put down together. Their order does not matter: whether the edge or the
    /// object token of a pixel comes first, the pixel is object and no edge in the end, and rows only look at others.
    class Pen {
      public:
        explicit Pen(EdgeMaps& maps)
            : edge_(maps.edge_.word_at(0, 0)),
              object_(maps.object_.word_at(0, 0)),
              row_(maps.edge_.words_per_row()),
              window_(static_cast<unsigned>(maps.window_)) {}
        ~Pen() { put_down(); }
        Pen(Pen const&) = delete;
        Pen& operator=(Pen const&) = delete;

        /// 1 if the token took two iterations.
        std::uint32_t take(EdgeToken const& token) {
            static_assert(static_cast<int>(EdgeTokenKind::Object) == 1, "the kind serves as a bit");
            if (static_cast<unsigned>(token.row) >= window_ || static_cast<unsigned>(token.col) >= window_)
                return 0;
            std::ptrdiff_t const at = token.row * row_ + (token.col >> 6);
            if (at != at_) {
                put_down();
                at_ = at;
            }
            auto const is_object = static_cast<std::uint32_t>(token.kind) & 1U;
            objects_ |= std::uint64_t{is_object} << (token.col & 63);
            edges_ |= std::uint64_t{is_object ^ 1U} << (token.col & 63);
            return is_object;
        }

      private:
        void put_down() {
            std::uint64_t* const edge = edge_ + at_;
            std::uint64_t* const object = object_ + at_;
            object[0] |= objects_;
            edge[0] = (edge[0] & ~objects_) | (edges_ & ~object[0]);
            edge[row_] |= objects_ & ~object[row_];
            edge[-row_] |= objects_ & ~object[-row_];
            objects_ = 0;
            edges_ = 0;
        }

        std::uint64_t* edge_;
        std::uint64_t* object_;
        std::ptrdiff_t row_;
        unsigned window_;
        std::ptrdiff_t at_ = 0;
        std::uint64_t objects_ = 0;
        std::uint64_t edges_ = 0;
    };

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
