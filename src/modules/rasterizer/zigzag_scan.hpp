#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "modules/rasterizer/triangle_setup.hpp"

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

/// What lies inside of a line of the zigzag, from the left whichever way the line goes.
struct CoveredRun {
    std::int64_t first;  ///< columns counted from the left wall; none is inside if first > last
    std::int64_t last;
    std::int64_t begin;  ///< the line's own first and last pixel; never the same
    std::int64_t end;
    std::int64_t z_sum;  ///< w0*z0 + w1*z1 + w2*z2 at the left wall

    bool covers() const { return first <= last; }
    bool rightwards() const { return begin < end; }
};

/// Walks the box of a drawn triangle in the order of docs/function.md#rasterizer: from the topmost vertex to a wall,
/// then wall to wall.
class ZigzagScan {
  public:
    /// Whether pixels outside that send no edge token take no iteration, but for one in a line that has nothing else.
    static constexpr bool skips_outside = false;

    explicit ZigzagScan(TriangleSetup const& setup);
    bool done() const { return row_ > bottom_; }
    ScanLine next_line();
    /// The next line, for those who do not care for the order of its pixels.
    CoveredRun next_run();

    int row() const { return row_; }  ///< of the next line
    bool is_last() const { return row_ == bottom_; }
    int left_wall() const { return left_wall_; }
    std::int64_t z_per_column() const { return z_per_column_; }

  private:
    /// Where an edge function changes its sign along the rows: the columns, counted from the left wall, at which it
    /// falls below zero, or from which on it no longer is. A quotient with its remainder, so that the next row's
    /// follows by adding.
    struct Bound {
        std::int64_t quotient;
        std::int64_t remainder;
        std::int64_t quotient_step;
        std::int64_t remainder_step;
        std::int64_t divisor;
        std::int64_t from_left;  ///< all bits set: the function grows along the row; otherwise none

        /// Without a branch: nobody could foretell it.
        void next_row() {
            std::int64_t const carried = remainder + remainder_step - divisor;
            std::int64_t const stays = carried >> 63;  // -1: no carry
            quotient += quotient_step + 1 + stays;
            remainder = carried + (divisor & stays);
        }
        /// First column inside, if it bounds from the left.
        std::int64_t first() const { return -quotient & from_left; }
        /// Last column inside, if it bounds from the right.
        std::int64_t last() const { return (quotient & ~from_left) | (widest & from_left); }
    };
    static Bound bound_of(EdgeFunction const& edge, std::int64_t at_left_wall);

    /// More columns than any box has.
    static constexpr std::int64_t widest = 0x7FFF;

    std::int64_t width_;  ///< of the box, less one
    int left_wall_;
    int bottom_;
    int row_;
    std::int64_t col_;  ///< counted from the left wall
    int step_;
    Bound bound_[3];
    std::int64_t z_sum_ = 0;  ///< at the left wall
    std::int64_t z_per_column_ = 0;
    std::int64_t z_per_row_ = 0;
};

// Inline: the rasterizer calls it for every few pixels.

inline ZigzagScan::Bound ZigzagScan::bound_of(EdgeFunction const& edge, std::int64_t at_left_wall) {
    if (edge.per_column == 0)  // all of a row is inside or none
        return {at_left_wall * (widest + 1) + widest, 0, edge.per_row * (widest + 1), 0, 1, 0};
    std::int64_t const divisor = std::abs(edge.per_column);
    double const inverse = 1.0 / static_cast<double>(divisor);
    // The product of an integer below 2^53 with a reciprocal is off by less than one: put right in integers.
    auto const divide = [divisor, inverse](std::int64_t value, std::int64_t& quotient, std::int64_t& remainder) {
        quotient = static_cast<std::int64_t>(static_cast<double>(value) * inverse);
        remainder = value - quotient * divisor;
        std::int64_t const correction = (remainder >= divisor ? 1 : 0) - (remainder < 0 ? 1 : 0);
        quotient += correction;
        remainder -= correction * divisor;
    };
    Bound bound{};
    bound.divisor = divisor;
    bound.from_left = edge.per_column > 0 ? -1 : 0;
    divide(at_left_wall, bound.quotient, bound.remainder);
    divide(edge.per_row, bound.quotient_step, bound.remainder_step);
    return bound;
}

inline ZigzagScan::ZigzagScan(TriangleSetup const& setup)
    : width_(setup.right_wall - setup.left_wall),
      left_wall_(setup.left_wall),
      bottom_(setup.bottom),
      row_(setup.start_row),
      col_(setup.start_col - setup.left_wall),
      step_(col_ == 0 ? 1 : -1) {
    for (int i = 0; i < 3; ++i) {
        EdgeFunction const& edge = setup.edge[i];
        std::int64_t const at_left_wall = edge.at_start - edge.per_column * col_;
        bound_[i] = bound_of(edge, at_left_wall);
        z_sum_ += at_left_wall * setup.z[i];
        z_per_column_ += edge.per_column * setup.z[i];
        z_per_row_ += edge.per_row * setup.z[i];
    }
}

inline CoveredRun ZigzagScan::next_run() {
    std::int64_t const end = step_ > 0 ? width_ : 0;
    CoveredRun run{};
    run.first = std::max({std::min(col_, end), bound_[0].first(), bound_[1].first(), bound_[2].first()});
    run.last = std::min({std::max(col_, end), bound_[0].last(), bound_[1].last(), bound_[2].last()});
    run.begin = col_;
    run.end = end;
    run.z_sum = z_sum_;
    for (Bound& bound : bound_)
        bound.next_row();
    z_sum_ += z_per_row_;
    col_ = end;
    step_ = -step_;
    ++row_;
    return run;
}

inline ScanLine ZigzagScan::next_line() {
    ScanLine line;
    line.row = row_;
    line.last = is_last();
    CoveredRun const run = next_run();
    bool const rightwards = run.rightwards();
    int const pixels = static_cast<int>(std::abs(run.end - run.begin)) + 1;
    std::int64_t const from = rightwards ? run.first : run.last;
    line.first_col = left_wall_ + static_cast<int>(run.begin);
    line.step = rightwards ? 1 : -1;
    line.inside = run.covers() ? static_cast<int>(run.last - run.first) + 1 : 0;
    line.before = run.covers() ? static_cast<int>(std::abs(from - run.begin)) : pixels;
    line.after = pixels - line.before - line.inside;
    line.z_sum = run.z_sum + from * z_per_column_;
    line.z_sum_per_step = rightwards ? z_per_column_ : -z_per_column_;
    return line;
}

}  // namespace faster::datapath
