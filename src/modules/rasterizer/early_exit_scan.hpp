#pragma once
#include <cstdlib>

#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster::datapath {

/// The zigzag, turned back early: a line ends at the first pixel from which on, in its direction, nothing covered can
/// follow, neither in its row nor, unless it is the last, in the row below, which is walked back from there. The sign
/// of an edge function that does not grow in that direction tells: below zero, it stays so. The last pixel of a line is
/// so beyond the runs of both rows, or at the wall, and edge tokens are those of the zigzag.
class EarlyExitScan {
  public:
    static constexpr bool skips_outside = false;

    explicit EarlyExitScan(TriangleSetup const& setup) : setup_(setup), zigzag_(setup), col_(setup.start_col) {}
    bool done() const { return zigzag_.done(); }

    ScanLine next_line() {
        ScanLine line = zigzag_.next_line();
        bool const is_empty = line.inside == 0;
        int const first_inside = line.col(line.before);
        int const last_inside = line.col(line.before + line.inside - 1);
        int const end = end_of(line, is_empty ? col_ : last_inside);
        line.first_col = col_;
        line.before = std::abs((is_empty ? end : first_inside) - col_) + (is_empty ? 1 : 0);
        line.after = is_empty ? 0 : std::abs(end - last_inside);
        col_ = end;
        return line;
    }

  private:
    int end_of(ScanLine const& line, int from) const {
        int const wall = line.step > 0 ? setup_.right_wall : setup_.left_wall;
        int col = from;
        while (col != wall &&
               !(is_beyond(line.row, col, line.step) && (line.last || is_beyond(line.row + 1, col, line.step))))
            col += line.step;
        return col;
    }

    bool is_beyond(int row, int col, int step) const {
        for (EdgeFunction const& edge : setup_.edge)
            if (edge.per_column * step <= 0 &&
                edge.at_start + edge.per_column * (col - setup_.start_col) + edge.per_row * (row - setup_.start_row) <
                    0)
                return true;
        return false;
    }

    TriangleSetup const& setup_;
    ZigzagScan zigzag_;
    int col_;  ///< where the next line begins
};

}  // namespace faster::datapath
