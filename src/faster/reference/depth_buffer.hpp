#pragma once
#include <cstdint>

#include "faster/data/fixed_point.hpp"
#include "faster/data/image.hpp"

namespace faster::reference {

/// Fragment depths of one triangle after the other: z sums times area reciprocals (docs/function.md#formats).
class FragmentDepth {
  public:
    /// Throws InputError if the fraction bits are negative or make the products wider than 127 bits.
    explicit FragmentDepth(FractionBits const& fraction);

    /// The next z sums belong to a triangle of this area, > 0, with 2 * vertex_xy fractional bits.
    void set_area(std::int64_t area_code);

    /// Depth with `fragment_depth` fractional bits. `z_sum` is that of a pixel the triangle covers, which bounds it to
    /// the area times the largest z code.
    std::uint64_t of(std::int64_t z_sum) const {
        if (fits_64_bits_) {
            return ((static_cast<std::uint64_t>(z_sum) * reciprocal_) >> right_shift_) << left_shift_;
        }
        return wide(z_sum);
    }

  private:
    std::uint64_t wide(std::int64_t z_sum) const;

    __extension__ using Uint128 = unsigned __int128;

    int reciprocal_exponent_;  // reciprocal code = floor(2^reciprocal_exponent_ / area code)
    int right_shift_;          // one of the two is 0
    int left_shift_;
    bool fits_64_bits_;
    std::uint64_t reciprocal_ = 0;
    Uint128 wide_reciprocal_ = 0;
};

/// The depth buffer of one sample while its fragments come in (docs/function.md#inlierunit; thesis A.3). Works on a
/// W x W buffer of the caller, which it fills with far. Rows and columns are those of the window and lie inside it.
class DepthBuffer {
  public:
    DepthBuffer(Image<std::uint16_t>& codes, FractionBits const& fraction);

    /// Keeps the fragment if it is at most 2 m away and not behind what the pixel has. `depth` as of FragmentDepth.
    void draw(int row, int col, std::uint64_t depth) {
        std::uint16_t& nearest = codes_.at(row, col);
        if (depth <= depth_limit_ && depth <= fragment_precision(nearest)) {
            nearest = buffer_precision(depth);
            ++valid_raster_;
        }
    }

    std::uint64_t valid_raster() const { return valid_raster_; }  ///< fragments kept, redraws included

  private:
    // Where fragments are the coarser ones this drops bits of the code, which cannot change the comparison: a fragment
    // is not above the code exactly if it is not above the code rounded down to the fragments' grid.
    std::uint64_t fragment_precision(std::uint16_t code) const {
        return (static_cast<std::uint64_t>(code) << finer_fragment_bits_) >> coarser_fragment_bits_;
    }
    std::uint16_t buffer_precision(std::uint64_t depth) const {
        return static_cast<std::uint16_t>((depth >> finer_fragment_bits_) << coarser_fragment_bits_);
    }

    Image<std::uint16_t>& codes_;
    int finer_fragment_bits_;  // fractional bits that fragments have beyond the buffer
    int coarser_fragment_bits_;
    std::uint64_t depth_limit_;
    std::uint64_t valid_raster_ = 0;
};

}  // namespace faster::reference
