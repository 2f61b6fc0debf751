#pragma once
#include <cmath>
#include <cstdint>

namespace faster {

/// Number of fractional bits of each quantity; keys `accelerator.fraction_bits.*` (docs/function.md#formats). The
/// widths are fixed (x, y: s16, z: u16, depth: u11): these numbers only move the binary point.
struct FractionBits {
    int vertex_xy = 4;         ///< vertex x, y [px], s16
    int vertex_z = 14;         ///< vertex z [m], u16
    int area_reciprocal = 30;  ///< 1 / area
    int fragment_depth = 18;   ///< depth of one fragment [m]
    int depth_buffer = 9;      ///< depth buffer and observed depth [m], u11

    friend bool operator==(FractionBits const& a, FractionBits const& b) {
        return a.vertex_xy == b.vertex_xy && a.vertex_z == b.vertex_z && a.area_reciprocal == b.area_reciprocal &&
               a.fragment_depth == b.fragment_depth && a.depth_buffer == b.depth_buffer;
    }
    friend bool operator!=(FractionBits const& a, FractionBits const& b) { return !(a == b); }
};

/// Depth code of "nothing drawn here", the largest u11 (thesis A.3: 3.99805).
constexpr std::uint16_t far_depth_code = 2047;

/// x = y of the vertices of a triangle that the rasterizer must reject (docs/function.md#vertex-transform).
constexpr std::int16_t rejected_vertex_code = -32768;

/// The code of `value` with `fraction_bits` bits after the point, 0 to 62, truncated towards minus infinity (HLS
/// AP_TRN). Multiplying by a power of two is exact.
inline double truncated_code(double value, int fraction_bits) {
    return std::floor(value * static_cast<double>(std::int64_t{1} << fraction_bits));
}

}  // namespace faster
