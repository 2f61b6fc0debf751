#pragma once
#include <cstdint>

#include "faster/data/fixed_point.hpp"

namespace faster::datapath {

/// floor(2^(area_reciprocal + 2*xy) / area), the code of 1 / area (docs/function.md#formats). `area` > 0; the sum of
/// bits is at most 62.
inline std::uint64_t reciprocal_of(std::int64_t area, FractionBits const& bits) {
    return (std::uint64_t{1} << (bits.area_reciprocal + 2 * bits.vertex_xy)) / static_cast<std::uint64_t>(area);
}

/// Moves the point of a non-negative code, rounding down.
constexpr std::uint64_t move_point(std::uint64_t code, int from_fraction, int to_fraction) {
    return from_fraction >= to_fraction ? code >> (from_fraction - to_fraction) : code << (to_fraction - from_fraction);
}

/// Depth arithmetic of one core: turns z sums into fragment depths and compares them with the depth buffer.
class DepthUnit {
  public:
    explicit DepthUnit(FractionBits const& bits)
        : shift_(2 * bits.vertex_xy + bits.vertex_z + bits.area_reciprocal - bits.fragment_depth),
          // z_sum * reciprocal <= z * 2^(reciprocal + 2*xy), z has 16 bits
          fits_(bits.area_reciprocal + 2 * bits.vertex_xy + 16 <= 63),
          fragment_fraction_(bits.fragment_depth),
          buffer_fraction_(bits.depth_buffer),
          farthest_drawn_(std::uint64_t{2} << bits.fragment_depth) {}

    /// floor(z_sum * reciprocal / 2^shift), at the fragment's precision.
    std::uint64_t fragment_depth(std::uint64_t z_sum, std::uint64_t reciprocal) const {
        if (fits_ && shift_ >= 0)
            return (z_sum * reciprocal) >> shift_;
        return wide_fragment_depth(z_sum, reciprocal);
    }

    /// For fragments side by side: their depths by adding to z_sum * reciprocal, of which shift() bits are dropped.
    /// False where fragment_depth() needs more bits.
    bool adds_up() const { return fits_ && shift_ >= 0; }
    int shift() const { return shift_; }

    /// Thesis A.3: draws a fragment that is at most 2 m away and not behind what is drawn. True if it was drawn.
    bool draw(std::uint64_t depth, std::uint16_t& buffer) const {
        if (depth > farthest_drawn_ || depth > move_point(buffer, buffer_fraction_, fragment_fraction_))
            return false;
        buffer = static_cast<std::uint16_t>(move_point(depth, fragment_fraction_, buffer_fraction_));
        return true;
    }

  private:
    std::uint64_t wide_fragment_depth(std::uint64_t z_sum, std::uint64_t reciprocal) const {
        __extension__ using Wide = unsigned __int128;
        Wide const product = Wide{z_sum} * reciprocal;
        return static_cast<std::uint64_t>(shift_ >= 0 ? product >> shift_ : product << -shift_);
    }

    int shift_;
    bool fits_;
    int fragment_fraction_;
    int buffer_fraction_;
    std::uint64_t farthest_drawn_;  ///< 2.0 m
};

}  // namespace faster::datapath
