#include "faster/workload/pictures/drawing.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

namespace {

constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr int text_thickness = 1;

/// OpenCV's view of the same pixels. Red stays first: nothing here depends on the order.
cv::Mat view(Image<Colour>& picture) { return {picture.height(), picture.width(), CV_8UC3, picture.pixels().data()}; }

Image<Colour> shrunk(Image<Colour> picture, int side) {
    Image<Colour> small(side, side);
    cv::Mat pixels = view(small);
    cv::resize(view(picture), pixels, pixels.size(), 0, 0, cv::INTER_AREA);
    return small;
}

}  // namespace

void fill(Image<Colour>& canvas, Box const& box, Colour colour) {
    for (int row = box.top; row < box.top + box.height; ++row)
        std::fill_n(canvas.row(row) + box.left, box.width, colour);
}

void paste(Image<Colour>& canvas, Image<Colour> const& picture, int top, int left) {
    for (int row = 0; row < picture.height(); ++row)
        std::copy_n(picture.row(row), picture.width(), canvas.row(top + row) + left);
}

Image<Colour> enlarged(Image<Colour> const& picture, int zoom) {
    Image<Colour> large(picture.height() * zoom, picture.width() * zoom);
    for (int row = 0; row < large.height(); ++row)
        for (int col = 0; col < large.width(); ++col)
            large.at(row, col) = picture.at(row / zoom, col / zoom);
    return large;
}

Image<Colour> fitted_square(Image<Colour> const& picture, int side) {
    return picture.width() > side ? shrunk(picture, side) : enlarged(picture, side / picture.width());
}

void draw_lines(Image<Colour>& canvas, std::vector<std::array<int, 2>> const& points, Colour colour, int thickness) {
    std::vector<cv::Point> corners;
    corners.reserve(points.size());
    for (auto const& [left, top] : points)
        corners.emplace_back(left, top);
    cv::Mat pixels = view(canvas);
    cv::polylines(pixels, corners, false, cv::Scalar(colour[0], colour[1], colour[2]), thickness, cv::LINE_AA);
}

void write_text(Image<Colour>& canvas, std::string const& text, int baseline, int left, double scale) {
    cv::Scalar const ink(palette::ink[0], palette::ink[1], palette::ink[2]);
    cv::Mat pixels = view(canvas);
    cv::putText(pixels, text, {left, baseline}, font, scale, ink, text_thickness, cv::LINE_AA);
}

int text_width(std::string const& text, double scale) {
    int baseline = 0;
    return cv::getTextSize(text, font, scale, text_thickness, &baseline).width;
}

}  // namespace faster::pictures
