#include "faster/reference/depth_buffer.hpp"

#include <algorithm>
#include <string>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::reference {
namespace {

constexpr int vertex_z_bits = 16;
constexpr int most_depth_bits = 46;  // depths of 16 more bits, and their doubles, still fit in 64

void check_range(char const* key, int bits, int highest) {
    if (bits < 0 || bits > highest) {
        throw InputError("fraction bits: " + std::string(key) + " = " + std::to_string(bits) + ", expected 0 to " +
                         std::to_string(highest) + ": the reference computes with at most 127 bits");
    }
}

void check(FractionBits const& fraction) {
    check_range("vertex_xy", fraction.vertex_xy, 30);
    check_range("vertex_z", fraction.vertex_z, 30);
    check_range("area_reciprocal", fraction.area_reciprocal, 127 - vertex_z_bits - 2 * fraction.vertex_xy);
    check_range("fragment_depth", fraction.fragment_depth, most_depth_bits);
    check_range("depth_buffer", fraction.depth_buffer, most_depth_bits);
}

}  // namespace

FragmentDepth::FragmentDepth(FractionBits const& fraction) {
    check(fraction);
    reciprocal_exponent_ = fraction.area_reciprocal + 2 * fraction.vertex_xy;
    // The weights of a covered pixel are not negative and add up to the area, so that
    // z_sum * reciprocal <= (area * 65535) * (2^exponent / area) < 2^(exponent + 16).
    int const product_bits = reciprocal_exponent_ + vertex_z_bits;
    fits_64_bits_ = product_bits <= 63;
    int const shift = reciprocal_exponent_ + fraction.vertex_z - fraction.fragment_depth;
    right_shift_ = std::clamp(shift, 0, product_bits);  // shifts everything out either way
    left_shift_ = std::max(-shift, 0);
}

void FragmentDepth::set_area(std::int64_t area_code) {
    if (fits_64_bits_) {
        reciprocal_ = (std::uint64_t{1} << reciprocal_exponent_) / static_cast<std::uint64_t>(area_code);
    } else {
        wide_reciprocal_ = (Uint128{1} << reciprocal_exponent_) / static_cast<Uint128>(area_code);
    }
}

std::uint64_t FragmentDepth::wide(std::int64_t z_sum) const {
    Uint128 const product = static_cast<Uint128>(z_sum) * wide_reciprocal_;
    return static_cast<std::uint64_t>((product >> right_shift_) << left_shift_);
}

DepthBuffer::DepthBuffer(Image<std::uint16_t>& codes, FractionBits const& fraction)
    : codes_(codes),
      finer_fragment_bits_(std::max(fraction.fragment_depth - fraction.depth_buffer, 0)),
      coarser_fragment_bits_(std::max(fraction.depth_buffer - fraction.fragment_depth, 0)),
      depth_limit_(std::uint64_t{2} << fraction.fragment_depth) {
    std::fill(codes_.pixels().begin(), codes_.pixels().end(), far_depth_code);
}

}  // namespace faster::reference
