#pragma once
#include <array>
#include <string>
#include <vector>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

/// A rectangle of pixels; (top, left) is its first.
struct Box {
    int top = 0;
    int left = 0;
    int height = 0;
    int width = 0;
};

void fill(Image<Colour>& canvas, Box const& box, Colour colour);

/// Copies `picture` to where its first pixel is (top, left); it must fit.
void paste(Image<Colour>& canvas, Image<Colour> const& picture, int top, int left);

/// Every pixel becomes zoom x zoom pixels.
Image<Colour> enlarged(Image<Colour> const& picture, int zoom);

/// A square picture with sides of at most `side`, and not much less: a whole zoom if it is smaller, else the mean of
/// the pixels that fall together.
Image<Colour> fitted_square(Image<Colour> const& picture, int side);

/// Straight lines from each point (left, top) to the next, smoothed at their edges.
void draw_lines(Image<Colour>& canvas, std::vector<std::array<int, 2>> const& points, Colour colour, int thickness);

/// Height of a capital letter is about 22 px times `scale`. Letters that leave the canvas are cut off.
void write_text(Image<Colour>& canvas, std::string const& text, int baseline, int left, double scale);
int text_width(std::string const& text, double scale);

}  // namespace faster::pictures
