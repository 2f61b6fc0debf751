#pragma once
#include <cstdint>

#include "datapath/triangle_setup.hpp"

namespace faster::datapath {

/// One line of the zigzag over a triangle's box. A triangle is convex, so the pixels inside it are one run.
struct ScanLine {
    int row = 0;
    int first_col = 0;
    int step = 1;            ///< +1 rightwards, -1 leftwards
    int before = 0;          ///< pixels outside, then
    int inside = 0;          ///< pixels inside, then
    int after = 0;           ///< pixels outside
    std::int64_t z_sum = 0;  ///< w0*z0 + w1*z1 + w2*z2 at the first pixel inside
    std::int64_t z_sum_per_step = 0;
    bool last = false;  ///< the triangle ends with this line

    int pixels() const { return before + inside + after; }
    int col(int i) const { return first_col + i * step; }
};

/// Walks the box of a drawn triangle in the order of SPEC section 2: from the topmost vertex to a wall, then wall to
/// wall.
class ZigzagScan {
  public:
    explicit ZigzagScan(TriangleSetup const& setup);
    bool done() const { return done_; }
    ScanLine next_line();

  private:
    TriangleSetup const& setup_;
    int row_;
    int col_;
    int step_;
    std::int64_t z_per_column_ = 0;
    std::int64_t w_[3];  ///< edge values at (row_, col_)
    bool done_ = false;
};

// Inline: the rasterizer calls it for every few pixels.

inline ZigzagScan::ZigzagScan(TriangleSetup const& setup)
    : setup_(setup),
      row_(setup.start_row),
      col_(setup.start_col),
      step_(setup.start_col == setup.left_wall ? 1 : -1),
      w_{setup.edge[0].at_start, setup.edge[1].at_start, setup.edge[2].at_start} {
    for (int i = 0; i < 3; ++i)
        z_per_column_ += setup.edge[i].per_column * setup.z[i];
}

inline ScanLine ZigzagScan::next_line() {
    ScanLine line;
    line.row = row_;
    line.first_col = col_;
    line.step = step_;
    line.last = row_ == setup_.bottom;
    int const end = step_ > 0 ? setup_.right_wall : setup_.left_wall;
    int const pixels = (end - col_) * step_ + 1;

    std::int64_t const d0 = setup_.edge[0].per_column * step_;
    std::int64_t const d1 = setup_.edge[1].per_column * step_;
    std::int64_t const d2 = setup_.edge[2].per_column * step_;
    std::int64_t w0 = w_[0], w1 = w_[1], w2 = w_[2];
    // An edge value that is negative and does not grow keeps the whole line outside.
    bool const misses = (w0 < 0 && d0 <= 0) || (w1 < 0 && d1 <= 0) || (w2 < 0 && d2 <= 0);
    int at = misses ? pixels : 0;
    for (; at < pixels && (w0 | w1 | w2) < 0; ++at)
        w0 += d0, w1 += d1, w2 += d2;
    line.before = at;
    line.z_sum = w0 * setup_.z[0] + w1 * setup_.z[1] + w2 * setup_.z[2];
    line.z_sum_per_step = step_ * z_per_column_;
    for (; at < pixels && (w0 | w1 | w2) >= 0; ++at)
        w0 += d0, w1 += d1, w2 += d2;
    line.inside = at - line.before;
    line.after = pixels - at;

    for (int i = 0; i < 3; ++i)
        w_[i] += setup_.edge[i].per_column * (end - col_) + setup_.edge[i].per_row;
    col_ = end;
    step_ = -step_;
    ++row_;
    done_ = line.last;
    return line;
}

}  // namespace faster::datapath
