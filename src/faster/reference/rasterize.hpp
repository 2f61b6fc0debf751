#pragma once
#include <cstddef>
#include <cstdint>

#include "faster/data/tokens.hpp"

namespace faster::reference {

/// One pixel of the image: row downwards, column to the right.
struct Pixel {
    int row = 0;
    int col = 0;
    friend bool operator==(Pixel const& a, Pixel const& b) { return a.row == b.row && a.col == b.col; }
};

/// The whole pixels that the corners of a triangle fall into, first and last included.
struct PixelBounds {
    int row_min = 0;
    int row_max = 0;
    int col_min = 0;
    int col_max = 0;
};

PixelBounds bounds_of(TriangleCode const& triangle, int xy_fraction_bits);

/// The pixel of the vertex with the smallest y, the first of them on a tie: where the scan starts.
Pixel start_pixel(TriangleCode const& triangle, int xy_fraction_bits);

/// Twice the area, E_01(V2), with 2 * xy_fraction_bits fractional bits; positive for a front face.
std::int64_t area_of(TriangleCode const& triangle);

/// E_ab (thesis eq. 2.6) at one pixel of the grid, carried along as the pixel moves.
class EdgeFunction {
  public:
    EdgeFunction(VertexCode const& a, VertexCode const& b, Pixel pixel, int xy_fraction_bits);

    std::int64_t value() const { return value_; }
    void next_row() { value_ += row_step_; }
    void move_columns(int columns) { value_ += columns * column_step_; }

  private:
    std::int64_t value_;
    std::int64_t row_step_;
    std::int64_t column_step_;
};

/// The three weights of a triangle at one pixel: w0 = E_12, w1 = E_20, w2 = E_01.
class PixelWeights {
  public:
    PixelWeights(TriangleCode const& triangle, Pixel pixel, int xy_fraction_bits);

    std::int64_t value(std::size_t i) const { return (i == 0 ? w0_ : i == 1 ? w1_ : w2_).value(); }
    bool inside() const { return w0_.value() >= 0 && w1_.value() >= 0 && w2_.value() >= 0; }
    std::int64_t z_sum() const { return w0_.value() * z0_ + w1_.value() * z1_ + w2_.value() * z2_; }
    void next_row() {
        w0_.next_row();
        w1_.next_row();
        w2_.next_row();
    }
    void move_columns(int columns) {
        w0_.move_columns(columns);
        w1_.move_columns(columns);
        w2_.move_columns(columns);
    }

  private:
    EdgeFunction w0_, w1_, w2_;
    std::int64_t z0_, z1_, z2_;
};

/// Zig-zag scan of a triangle that is to be drawn, in the order of thesis A.1. Tells `sink`
///   fragment(Pixel, z_sum)  a covered pixel, its z sum not yet divided by the area
/// and what `tokens` makes of the pixel (edge_tokens.hpp):
///   object(Pixel), edge(Pixel)
template <class Tokens, class Sink>
void scan(TriangleCode const& triangle, PixelBounds const& bounds, int xy_fraction_bits, Tokens& tokens, Sink& sink) {
    int const left_wall = bounds.col_min;
    int const right_wall = bounds.col_max + 1;
    Pixel pixel = start_pixel(triangle, xy_fraction_bits);
    PixelWeights weights(triangle, pixel, xy_fraction_bits);
    int direction = pixel.col == left_wall ? 1 : -1;
    int line_start = pixel.col;
    tokens.begin(pixel, weights);

    while (true) {
        bool const inside = weights.inside();
        if (inside) {
            sink.fragment(pixel, weights.z_sum());
        }
        tokens.visit(pixel, weights, inside, sink);

        bool const at_wall = pixel.col == left_wall || pixel.col == right_wall;
        if (at_wall && pixel.col != line_start) {
            if (pixel.row == bounds.row_max) {
                return;
            }
            ++pixel.row;
            weights.next_row();
            direction = -direction;
            line_start = pixel.col;
        } else {
            pixel.col += direction;
            weights.move_columns(direction);
        }
    }
}

/// Draws one triangle into `sink` (docs/function.md#rasterizer): `triangle(area code)`, then what scan() tells. Nothing
/// at all if one of its corners is outside the image of width x height pixels or its area is not positive.
template <class Tokens, class Sink>
void rasterize(TriangleCode const& triangle, int width, int height, int xy_fraction_bits, Tokens& tokens, Sink& sink) {
    PixelBounds const bounds = bounds_of(triangle, xy_fraction_bits);
    if (bounds.row_min < 0 || bounds.col_min < 0 || bounds.row_max >= height || bounds.col_max >= width) {
        return;
    }
    std::int64_t const area = area_of(triangle);
    if (area <= 0) {
        return;
    }
    sink.triangle(area);
    scan(triangle, bounds, xy_fraction_bits, tokens, sink);
}

}  // namespace faster::reference
