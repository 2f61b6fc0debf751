#include "poses/quality/contour_quality.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "poses/quality/as_mat.hpp"

namespace faster::quality {

namespace {

using Map = Image<std::uint8_t>;

double ratio(int part, int whole, double of_nothing) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : of_nothing;
}

/// Everything within 2 px, corners of the square included.
cv::Mat surroundings(cv::Mat const& map) {
    cv::Mat near;
    cv::dilate(map, near, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
    return near;
}

/// Edge pixels in a row through one of them, counted in one of the directions; more than enough is enough.
int run_length(cv::Mat const& edges, cv::Point pixel, cv::Point step) {
    constexpr int enough = 16;
    cv::Rect const window({0, 0}, edges.size());
    int length = 1;
    for (cv::Point const direction : {step, cv::Point(-step.x, -step.y)})
        for (cv::Point at = pixel + direction;
             length < enough && window.contains(at) && edges.at<std::uint8_t>(at) != 0; at += direction)
            ++length;
    return length;
}

/// How thick the line through a pixel is: its shortest run in the four directions.
int width_at(cv::Mat const& edges, cv::Point pixel) {
    return std::min({run_length(edges, pixel, {1, 0}), run_length(edges, pixel, {0, 1}),
                     run_length(edges, pixel, {1, 1}), run_length(edges, pixel, {1, -1})});
}

/// Mean over the edge pixels near the contour.
double thickness(cv::Mat const& edges, cv::Mat const& contour) {
    std::vector<cv::Point> near_edges;
    cv::findNonZero(edges & surroundings(contour), near_edges);
    int sum = 0;
    for (cv::Point const& pixel : near_edges)
        sum += width_at(edges, pixel);
    return ratio(sum, static_cast<int>(near_edges.size()), 0);
}

/// What is left between the edges, connected over sides, is object or not, but never both.
bool parts_object_from_rest(cv::Mat const& edges, cv::Mat const& silhouette) {
    cv::Mat labels;
    int const count = cv::connectedComponents(edges == 0, labels, 4, CV_32S);
    std::vector<unsigned> holds(static_cast<std::size_t>(count), 0U);
    for (int row = 0; row < labels.rows; ++row)
        for (int col = 0; col < labels.cols; ++col)
            holds[static_cast<std::size_t>(labels.at<int>(row, col))] |=
                silhouette.at<std::uint8_t>(row, col) != 0 ? 1U : 2U;
    // Label 0 is the edges themselves.
    return std::none_of(holds.begin() + 1, holds.end(), [](unsigned both) { return both == 3U; });
}

/// The upper left pixels of all 2 x 2 blocks.
cv::Mat blocks(cv::Mat const& map) {
    cv::Mat found;
    cv::erode(map, found, cv::Mat::ones(2, 2, CV_8U), {0, 0}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    return found;
}

}  // namespace

ContourQuality contour_quality(Map const& edge_map, Map const& silhouette, ContourSide side) {
    cv::Mat const edges = as_mat(edge_map);
    cv::Mat const contour = as_mat(contour_of(silhouette, side));
    int const common = cv::countNonZero(edges & contour);
    ContourQuality quality;
    quality.precision = ratio(common, cv::countNonZero(edges), 0);
    quality.recall = ratio(common, cv::countNonZero(contour), 1);
    quality.thickness = thickness(edges, contour);
    quality.is_closed = parts_object_from_rest(edges, as_mat(silhouette));
    quality.is_thin = cv::countNonZero(blocks(edges) > blocks(contour)) == 0;
    return quality;
}

}  // namespace faster::quality
