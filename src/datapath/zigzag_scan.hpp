#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>

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
    /// The pixels before the run inside, and its length.
    struct Run {
        int before = 0;
        int inside = 0;
    };
    Run find_run(int pixels) const;

    TriangleSetup const& setup_;
    int row_;
    int col_;
    int step_;
    std::int64_t z_per_column_ = 0;
    std::int64_t change_[3];  ///< of each edge value per column, without its sign
    double inverse_[3];       ///< one over that
    std::int64_t w_[3];       ///< edge values at (row_, col_)
    bool done_ = false;
};

// Inline: the rasterizer calls it for every few pixels.

inline ZigzagScan::ZigzagScan(TriangleSetup const& setup)
    : setup_(setup),
      row_(setup.start_row),
      col_(setup.start_col),
      step_(setup.start_col == setup.left_wall ? 1 : -1),
      w_{setup.edge[0].at_start, setup.edge[1].at_start, setup.edge[2].at_start} {
    for (int i = 0; i < 3; ++i) {
        std::int64_t const change = setup.edge[i].per_column;
        z_per_column_ += change * setup.z[i];
        change_[i] = std::abs(change);
        inverse_[i] = 1.0 / static_cast<double>(change_[i]);
    }
}

/// Where the line's run inside begins and ends. An edge value that grows along the line bounds it from the left, one
/// that falls from the right. A quotient of two integers below 2^53, taken as a product with the divisor's reciprocal,
/// is off by less than one, and only where it comes out even: that is put right in integers.
inline ZigzagScan::Run ZigzagScan::find_run(int pixels) const {
    std::int64_t first = 0;
    std::int64_t end = pixels;
    for (int i = 0; i < 3; ++i) {
        std::int64_t const w = w_[i];
        if (change_[i] == 0) {
            end = w < 0 ? 0 : end;
            continue;
        }
        auto const quotient = static_cast<std::int64_t>(static_cast<double>(w < 0 ? -w : w) * inverse_[i]);
        std::int64_t const exact = (quotient + 1) * change_[i];
        if (setup_.edge[i].per_column * step_ > 0) {
            std::int64_t const steps = quotient + (quotient * change_[i] < -w ? 1 : 0);
            first = w < 0 ? std::max(first, steps) : first;
        } else {
            std::int64_t const steps = quotient + (exact <= w ? 1 : 0);
            end = w < 0 ? 0 : std::min(end, steps + 1);
        }
    }
    if (end <= first)
        return {pixels, 0};
    return {static_cast<int>(first), static_cast<int>(end - first)};
}

inline ScanLine ZigzagScan::next_line() {
    ScanLine line;
    line.row = row_;
    line.first_col = col_;
    line.step = step_;
    line.last = row_ == setup_.bottom;
    int const end = step_ > 0 ? setup_.right_wall : setup_.left_wall;
    int const pixels = (end - col_) * step_ + 1;

    Run const run = find_run(pixels);
    line.before = run.before;
    line.inside = run.inside;
    line.after = pixels - run.before - run.inside;
    for (int i = 0; i < 3; ++i)
        line.z_sum += (w_[i] + run.before * step_ * setup_.edge[i].per_column) * setup_.z[i];
    line.z_sum_per_step = step_ * z_per_column_;

    for (int i = 0; i < 3; ++i)
        w_[i] += setup_.edge[i].per_column * (end - col_) + setup_.edge[i].per_row;
    col_ = end;
    step_ = -step_;
    ++row_;
    done_ = line.last;
    return line;
}

}  // namespace faster::datapath
