#include "poses/quality/silhouette.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "poses/quality/as_mat.hpp"

namespace faster::quality {

namespace {

std::int64_t edge_value(VertexCode const& a, VertexCode const& b, std::int64_t x, std::int64_t y) {
    return (x - a.x) * (b.y - a.y) - (std::int64_t{b.x} - a.x) * (y - a.y);
}

/// Columns and rows of the image that the corners fall into.
struct Box {
    int left, right, top, bottom;
};

Box box_of(TriangleCode const& triangle, int xy_fraction) {
    auto const& [a, b, c] = triangle.vertex;
    auto const [left, right] = std::minmax({a.x, b.x, c.x});
    auto const [top, bottom] = std::minmax({a.y, b.y, c.y});
    return {left >> xy_fraction, right >> xy_fraction, top >> xy_fraction, bottom >> xy_fraction};
}

bool is_drawn(TriangleCode const& triangle, Box const& box, Stimulus const& stimulus) {
    auto const& [a, b, c] = triangle.vertex;
    return box.left >= 0 && box.top >= 0 && box.right < stimulus.width && box.bottom < stimulus.height &&
           edge_value(a, b, c.x, c.y) > 0;
}

bool covers(TriangleCode const& triangle, std::int64_t x, std::int64_t y) {
    auto const& [a, b, c] = triangle.vertex;
    return edge_value(a, b, x, y) >= 0 && edge_value(b, c, x, y) >= 0 && edge_value(c, a, x, y) >= 0;
}

}  // namespace

Image<std::uint8_t> silhouette(std::vector<TriangleCode> const& triangles, Stimulus const& stimulus,
                               SampleInput const& sample) {
    Image<std::uint8_t> mask(stimulus.window, stimulus.window);
    int const row_offset = stimulus.near_window_offset(sample.centre_row);
    int const col_offset = stimulus.near_window_offset(sample.centre_col);
    std::int64_t const pixel = std::int64_t{1} << stimulus.fraction.vertex_xy;
    for (TriangleCode const& triangle : triangles) {
        Box const box = box_of(triangle, stimulus.fraction.vertex_xy);
        if (!is_drawn(triangle, box, stimulus))
            continue;
        for (int row = box.top; row <= box.bottom; ++row)
            for (int col = box.left; col <= box.right; ++col)
                if (mask.contains(row - row_offset, col - col_offset) && covers(triangle, col * pixel, row * pixel))
                    mask.at(row - row_offset, col - col_offset) = 1;
    }
    return mask;
}

Image<std::uint8_t> contour_of(Image<std::uint8_t> const& silhouette, ContourSide side) {
    cv::Mat const mask = as_mat(silhouette);
    cv::Mat const cross = cv::getStructuringElement(cv::MORPH_CROSS, {3, 3});
    cv::Mat moved;
    // OpenCV's default border never wins: what lies outside neither grows in nor eats away.
    side == ContourSide::outside ? cv::dilate(mask, moved, cross) : cv::erode(mask, moved, cross);
    Image<std::uint8_t> contour(silhouette.height(), silhouette.width());
    std::transform(mask.begin<std::uint8_t>(), mask.end<std::uint8_t>(), moved.begin<std::uint8_t>(),
                   contour.pixels().begin(), [](std::uint8_t a, std::uint8_t b) { return std::uint8_t{a != b}; });
    return contour;
}

}  // namespace faster::quality
