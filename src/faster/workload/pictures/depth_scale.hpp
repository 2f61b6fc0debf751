#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "faster/data/fixed_point.hpp"
#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

/// Which depths a picture shows, and in which colours: viridis, bright is near. Depths are codes of the depth buffer;
/// 2047 (far) means that nothing was drawn.
class DepthScale {
  public:
    static constexpr int shades = 256;

    /// `fraction_bits`: 1 m is 2^fraction_bits.
    explicit DepthScale(int fraction_bits) : fraction_bits_(fraction_bits) {}

    /// Widens the scale to what is drawn in this depth buffer.
    void include(Image<std::uint16_t> const& depth_buffer);

    /// False as long as nothing drawn was included.
    bool has_depths() const { return nearest_ <= farthest_; }
    double nearest_metres() const { return metres(first()); }
    double farthest_metres() const { return metres(last()); }

    /// 0 is nearest, shades - 1 is farthest. Depths beyond the scale get the nearer end.
    int shade(std::uint16_t code) const;
    Colour colour(std::uint16_t code) const;

    /// Round depths on the scale, three to nine, near to far [m].
    std::vector<double> ticks() const;
    /// Where a depth lies: 0 nearest, 1 farthest.
    double position(double depth_metres) const;
    /// A depth with its unit, as precise as the ticks.
    std::string label(double depth_metres) const;

  private:
    /// A scale of one depth would have no length.
    static constexpr int fewest_codes = 8;

    int first() const;
    int last() const;
    double tick_step() const;
    double metres(int code) const;

    int fraction_bits_;
    int nearest_ = far_depth_code;  // codes; no depth included yet
    int farthest_ = -1;
};

/// Colour of a shade.
Colour viridis(int shade);

}  // namespace faster::pictures
