#pragma once
#include <algorithm>
#include <cstddef>

#include "faster/data/pixel_box.hpp"

namespace faster {

/// A window of `side` x `side` pixels as tokens of `lanes` pixels of a row, or the part of it that covers a box. Rows
/// are padded: each begins with a token of its own, and its last token may have pixels beyond the window.
class LaneRows {
  public:
    LaneRows(int side, int lanes) : LaneRows(side, lanes, {0, 0, side, side}) {}
    /// `box` lies in the window. Its tokens are those of the window that have a pixel of it.
    LaneRows(int side, int lanes, PixelBox const& box)
        : side_(static_cast<std::size_t>(side)),
          lanes_(static_cast<std::size_t>(lanes)),
          rows_(box.empty() ? 0 : static_cast<std::size_t>(box.rows())),
          first_row_(static_cast<std::size_t>(box.first_row)),
          first_token_(static_cast<std::size_t>(box.first_col) / lanes_),
          end_token_((static_cast<std::size_t>(box.end_col) + lanes_ - 1) / lanes_) {}

    std::size_t lanes() const { return lanes_; }
    std::size_t rows() const { return rows_; }
    std::size_t first_row() const { return first_row_; }
    std::size_t first_col() const { return first_token_ * lanes_; }
    std::size_t tokens_per_row() const { return end_token_ - first_token_; }
    std::size_t tokens() const { return rows_ * tokens_per_row(); }

    /// Tokens that follow each other, with the pixels of the window that are in them, row-major. What is left in the
    /// last token is padding.
    struct Run {
        std::size_t tokens;
        std::size_t first_pixel;
        std::size_t pixels;
    };

    /// The longest run from token `first` on, `most` tokens at most: to the end of the row, or over all rows where none
    /// is padded or cut.
    Run run(std::size_t first, std::size_t most) const {
        if (lanes_ == 1 && tokens_per_row() == side_)
            return {most, first_row_ * side_ + first, most};
        std::size_t const row = first_row_ + first / tokens_per_row();
        std::size_t const begin = first % tokens_per_row();
        std::size_t const end = std::min(begin + most, tokens_per_row());
        std::size_t const first_col = (first_token_ + begin) * lanes_;
        return {end - begin, row * side_ + first_col, std::min((first_token_ + end) * lanes_, side_) - first_col};
    }

  private:
    std::size_t side_;
    std::size_t lanes_;
    std::size_t rows_;
    std::size_t first_row_;
    std::size_t first_token_;
    std::size_t end_token_;
};

}  // namespace faster
