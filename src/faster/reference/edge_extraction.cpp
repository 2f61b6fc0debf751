#include "faster/reference/edge_extraction.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace faster::reference {
namespace {

using Vector = std::array<std::int64_t, 3>;

/// s18.15 of a row's or column's distance from the window's centre, per metre of depth; saturates.
std::int64_t slope_code(int position, int window, double focal_length_px) {
    int const from_centre = position - window / 2;
    double const code = std::floor(from_centre / focal_length_px * 32768.0);
    if (code > 131071.0) {
        return 131071;
    }
    return code < -131072.0 ? -131072 : static_cast<std::int64_t>(code);
}

/// Digit by digit.
std::uint64_t integer_root(std::uint64_t value) {
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
        if ((root + bit) * (root + bit) <= value) {
            root += bit;
        }
    }
    return root;
}

/// Of four of the fraction's fifteen bits.
std::uint64_t norm(Vector const& vector) {
    std::uint64_t squares = 0;
    for (std::int64_t const component : vector) {
        std::int64_t const kept = component >= 0 ? component / 2048 : -((-component + 2047) / 2048);
        squares += static_cast<std::uint64_t>(kept * kept);
    }
    return integer_root(squares);
}

class Cloud {
  public:
    Cloud(Image<std::uint16_t> const& depth, double focal_length_px) : depth_(depth), focal_length_(focal_length_px) {}

    Vector point(int row, int col) const {
        std::int64_t const z = depth_.at(row, col);
        return {z * slope_code(col, depth_.width(), focal_length_), z * slope_code(row, depth_.height(), focal_length_),
                z * 32768};
    }

    /// c(u, v) with 16 fractional bits; 0 where it is not defined.
    std::uint64_t curvature(int row, int col, int radius) const {
        Vector const p = point(row, col);
        Vector sum{};
        std::uint64_t neighbours = 0;
        for (int r = row - radius; r <= row + radius; ++r) {
            for (int c = col - radius; c <= col + radius; ++c) {
                if (!depth_.contains(r, c) || (r == row && c == col)) {
                    continue;
                }
                Vector const q = point(r, c);
                for (std::size_t i = 0; i < sum.size(); ++i) {
                    sum[i] += q[i] - p[i];
                }
                ++neighbours;
            }
        }
        std::uint64_t const divisor = neighbours * norm(p);
        return divisor == 0 ? 0 : norm(sum) * 65536 / divisor;
    }

  private:
    Image<std::uint16_t> const& depth_;
    double focal_length_;
};

}  // namespace

void extract_edges(EdgeExtractionConfig const& config, int depth_fraction_bits, SampleMaps& maps) {
    auto const threshold = static_cast<std::uint64_t>(config.threshold * 65536.0);
    int const drawn_below = 2 << depth_fraction_bits;
    Cloud const cloud(maps.depth_buffer, config.focal_length_px);
    for (int row = 0; row < maps.depth_buffer.height(); ++row) {
        for (int col = 0; col < maps.depth_buffer.width(); ++col) {
            bool const drawn = maps.depth_buffer.at(row, col) < drawn_below;
            bool const edge = drawn && cloud.curvature(row, col, config.neighbourhood / 2) > threshold;
            maps.object_map.at(row, col) = drawn ? 1 : 0;
            maps.edge_map.at(row, col) = edge ? 1 : 0;
        }
    }
}

}  // namespace faster::reference
