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
    std::int64_t w_[3];  ///< edge values at (row_, col_)
    bool done_ = false;
};

}  // namespace faster::datapath
