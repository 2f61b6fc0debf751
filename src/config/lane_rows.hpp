#pragma once
#include <algorithm>
#include <cstddef>

namespace faster {

/// A window of `side` x `side` pixels as tokens of `lanes` pixels of a row. Rows are padded: each begins with a token
/// of its own, and its last token may have pixels beyond the window.
class LaneRows {
  public:
    LaneRows(int side, int lanes) : side_(static_cast<std::size_t>(side)), lanes_(static_cast<std::size_t>(lanes)) {}

    std::size_t lanes() const { return lanes_; }
    std::size_t tokens_per_row() const { return (side_ + lanes_ - 1) / lanes_; }
    std::size_t tokens() const { return side_ * tokens_per_row(); }

    /// Tokens that follow each other, with the pixels of the window that are in them, row-major. What is left in the
    /// last token is padding.
    struct Run {
        std::size_t tokens;
        std::size_t first_pixel;
        std::size_t pixels;
    };

    /// The longest run from token `first` on, `most` tokens at most: to the end of the row, or over all rows where none
    /// is padded.
    Run run(std::size_t first, std::size_t most) const {
        if (lanes_ == 1)
            return {most, first, most};
        std::size_t const row = first / tokens_per_row();
        std::size_t const begin = first % tokens_per_row();
        std::size_t const end = std::min(begin + most, tokens_per_row());
        std::size_t const first_col = begin * lanes_;
        return {end - begin, row * side_ + first_col, std::min(end * lanes_, side_) - first_col};
    }

  private:
    std::size_t side_;
    std::size_t lanes_;
};

}  // namespace faster
