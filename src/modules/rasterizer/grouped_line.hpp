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
          run_begin_(group_at(line.before)) {}

    bool is_empty() const { return line_.inside == 0; }
    int groups() const { return distance(0, line_.pixels() - 1); }
    /// Groups without a covered pixel, then those with one, then others; of a line with a covered pixel.
    int before() const { return std::abs(run_begin_ - group_at(0)); }
    int inside() const { return distance(line_.before, line_.before + line_.inside - 1); }
    int after() const { return groups() - before() - inside(); }

    /// The i-th group with a covered pixel.
    PixelGroup pixels(int i) const {
        int const first = first_col(i);
        int const ends[]{col(line_.before), col(line_.before + line_.inside - 1)};
        int const from = std::max(std::min(ends[0], ends[1]) - first, 0);
        int const to = std::min(std::max(ends[0], ends[1]) - first, lanes_ - 1);
        auto const mask = static_cast<std::uint32_t>((std::uint64_t{2} << to) - (std::uint64_t{1} << from));
        return {static_cast<std::int16_t>(row_), static_cast<std::int16_t>(first), mask};
    }
    DepthGroup depths(int i) const {
        std::int64_t const per_column = line_.step * line_.z_sum_per_step;
        return {line_.z_sum + (first_col(i) - col(line_.before)) * per_column, per_column};
    }

  private:
    int col(int pixel) const { return line_.col(pixel) - col_offset_; }
    int group_at(int pixel) const {
        int const at = col(pixel);
        return (at >= 0 ? at : at - lanes_ + 1) / lanes_;
    }
    int distance(int from, int to) const { return std::abs(group_at(to) - group_at(from)) + 1; }
    int first_col(int i) const { return (run_begin_ + i * line_.step) * lanes_; }

    ScanLine line_;
    int row_;
    int col_offset_;
    int lanes_;
    int run_begin_;  ///< group of the first covered pixel
};

}  // namespace faster::datapath
