#include "faster/reference/rasterize.hpp"

#include <algorithm>
#include <iterator>

namespace faster::reference {
namespace {

// The pixel that holds a coordinate: floor, as the shift of a negative code is arithmetic on every compiler we build
// on.
int whole_pixels(int code, int fraction_bits) { return code >> fraction_bits; }

std::int64_t edge_function(VertexCode const& a, VertexCode const& b, std::int64_t x, std::int64_t y) {
    return (x - a.x) * (b.y - a.y) - (b.x - a.x) * (y - a.y);
}

}  // namespace

PixelBounds bounds_of(TriangleCode const& triangle, int xy_fraction_bits) {
    auto const& [a, b, c] = triangle.vertex;
    auto const [x_min, x_max] = std::minmax({a.x, b.x, c.x});
    auto const [y_min, y_max] = std::minmax({a.y, b.y, c.y});
    return {whole_pixels(y_min, xy_fraction_bits), whole_pixels(y_max, xy_fraction_bits),
            whole_pixels(x_min, xy_fraction_bits), whole_pixels(x_max, xy_fraction_bits)};
}

Pixel start_pixel(TriangleCode const& triangle, int xy_fraction_bits) {
    auto const higher = [](VertexCode const& a, VertexCode const& b) { return a.y < b.y; };
    VertexCode const& top = *std::min_element(std::begin(triangle.vertex), std::end(triangle.vertex), higher);
    return {whole_pixels(top.y, xy_fraction_bits), whole_pixels(top.x, xy_fraction_bits)};
}

std::int64_t area_of(TriangleCode const& triangle) {
    auto const& [a, b, c] = triangle.vertex;
    return edge_function(a, b, c.x, c.y);
}

EdgeFunction::EdgeFunction(VertexCode const& a, VertexCode const& b, Pixel pixel, int xy_fraction_bits) {
    std::int64_t const codes_per_px = std::int64_t{1} << xy_fraction_bits;
    value_ = edge_function(a, b, pixel.col * codes_per_px, pixel.row * codes_per_px);
    row_step_ = -(b.x - a.x) * codes_per_px;
    column_step_ = (b.y - a.y) * codes_per_px;
}

PixelWeights::PixelWeights(TriangleCode const& triangle, Pixel pixel, int xy_fraction_bits)
    : w0_(triangle.vertex[1], triangle.vertex[2], pixel, xy_fraction_bits),
      w1_(triangle.vertex[2], triangle.vertex[0], pixel, xy_fraction_bits),
      w2_(triangle.vertex[0], triangle.vertex[1], pixel, xy_fraction_bits),
      z0_(triangle.vertex[0].z),
      z1_(triangle.vertex[1].z),
      z2_(triangle.vertex[2].z) {}

}  // namespace faster::reference
