#pragma once
#include <cstdint>
#include <vector>

#include "faster/data/image.hpp"

namespace faster::datapath {

/// How many pixels of a window have a valid observed depth, up to 3.0 m, its border left out
/// (docs/function.md#inlierunit): four reads of a summed-area table of the pixels that have none. A pixel outside the
/// image reads as 0, which is valid.
class ValidDepthTable {
  public:
    /// `depth`: codes with `depth_fraction` fractional bits.
    ValidDepthTable(Image<std::uint16_t> const& depth, int depth_fraction);

    /// `first_row`, `first_col`: of the window in the image, which it may leave; `side` [px].
    std::uint64_t count(std::int64_t first_row, std::int64_t first_col, int side) const;

  private:
    /// Invalid pixels above `row` and left of `col`.
    std::uint64_t invalid_before(std::int64_t row, std::int64_t col) const;

    std::int64_t height_;
    std::int64_t width_;
    std::vector<std::uint32_t> invalid_;  ///< (height + 1) x (width + 1)
};

}  // namespace faster::datapath
