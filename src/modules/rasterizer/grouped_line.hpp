#pragma once
#include <algorithm>
#include <cstdlib>

#include "faster/data/tokens.hpp"
#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster::datapath {

/// A line of a scan, `lanes` adjacent pixels at a time, in its direction. Groups begin at multiples of `lanes` from the
/// window's first column on, so a pixel's column alone decides which lane tests it. A line's ends may lie within
/// a group, whose pixels beyond them are not tested.
class GroupedLine {
  public:
    /// `row_offset`, `col_offset`: the window's first pixel in the image; `lanes` 1 to 32
    GroupedLine(ScanLine const& line, int row_offset, int col_offset, int lanes)
        : line_(line),
          row_(line.row - row_offset),
          col_offset_(col_offset),
          lanes_(lanes),
          run_first_(col(line.before)),
          run_last_(col(line.before + line.inside - 1)),
          run_begin_(group_of(run_first_)),
          run_end_(group_of(run_last_)) {}

    bool is_empty() const { return line_.inside == 0; }
    int groups() const { return std::abs(group_at(line_.pixels() - 1) - group_at(0)) + 1; }
    /// Groups without a covered pixel, then those with one, then others; of a line with a covered pixel.
    int before() const { return std::abs(run_begin_ - group_at(0)); }
    int inside() const { return std::abs(run_end_ - run_begin_) + 1; }
    int after() const { return groups() - before() - inside(); }

    int row() const { return row_; }
    /// Of the covered pixels.
    int first_col() const { return std::min(run_first_, run_last_); }
    int last_col() const { return std::max(run_first_, run_last_); }

    /// The i-th group with a covered pixel.
    PixelGroup pixels(int i) const {
        int const first = group_col(i);
        int const from = std::max(first_col() - first, 0);
        int const to = std::min(last_col() - first, lanes_ - 1);
        auto const mask = static_cast<std::uint32_t>((std::uint64_t{2} << to) - (std::uint64_t{1} << from));
        return {static_cast<std::int16_t>(row_), static_cast<std::int16_t>(first), mask};
    }
    DepthGroup depths(int i) const {
        std::int64_t const per_column = line_.step * line_.z_sum_per_step;
        return {line_.z_sum + (group_col(i) - run_first_) * per_column, per_column};
    }

  private:
    int col(int pixel) const { return line_.col(pixel) - col_offset_; }
    int group_of(int col) const { return (col >= 0 ? col : col - lanes_ + 1) / lanes_; }
    int group_at(int pixel) const { return group_of(col(pixel)); }
    int group_col(int i) const { return (run_begin_ + i * line_.step) * lanes_; }

    ScanLine line_;
    int row_;
    int col_offset_;
    int lanes_;
    int run_first_;  ///< column of the first covered pixel, along the scan
    int run_last_;
    int run_begin_;  ///< groups of those
    int run_end_;
};

}  // namespace faster::datapath
