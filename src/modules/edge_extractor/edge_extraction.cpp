#include "modules/edge_extractor/edge_extraction.hpp"

#include <algorithm>
#include <cmath>

#include "modules/inlier_unit/compared_pixels.hpp"

namespace faster::datapath {

namespace {

constexpr int slope_fraction = 15;
constexpr double largest_slope = 131071;  // s18
constexpr int dropped_bits = 11;          // before squaring, of the slopes' fraction
constexpr int quotient_fraction = 16;

std::vector<std::int64_t> slopes(int window, double focal_length_px) {
    std::vector<std::int64_t> codes(static_cast<std::size_t>(window));
    int const centre = window / 2;
    for (int i = 0; i < window; ++i) {
        double const slope = std::floor(std::ldexp((i - centre) / focal_length_px, slope_fraction));
        codes[static_cast<std::size_t>(i)] =
            static_cast<std::int64_t>(std::clamp(slope, -largest_slope - 1, largest_slope));
    }
    return codes;
}

/// floor(sqrt(value)) below 2^63: the double's root, put right.
std::uint64_t square_root(std::uint64_t value) {
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(value)));
    while (root * root > value)
        --root;
    while ((root + 1) * (root + 1) <= value)
        ++root;
    return root;
}

std::uint64_t square(std::int64_t component) {
    std::int64_t const kept = component >> dropped_bits;
    return static_cast<std::uint64_t>(kept * kept);
}

template <class Vector> std::uint64_t length(Vector const& vector) {
    return square_root(square(vector.x) + square(vector.y) + square(vector.z));
}

}  // namespace

EdgeExtraction::EdgeExtraction(EdgeExtractionConfig const& config, int window, int depth_fraction)
    : window_(window),
      radius_(config.neighbourhood / 2),
      near_limit_(drawn_below(depth_fraction)),
      threshold_code_(static_cast<std::uint64_t>(std::floor(std::ldexp(config.threshold, quotient_fraction)))),
      slope_(slopes(window, config.focal_length_px)),
      depths_(static_cast<std::size_t>(window)),
      ys_(static_cast<std::size_t>(window)) {}

int EdgeExtraction::first(int position) const { return std::max(0, position - radius_); }
int EdgeExtraction::end(int position) const { return std::min(window_, position + radius_ + 1); }

void EdgeExtraction::extract(std::vector<std::uint16_t> const& depth_buffer, std::vector<std::uint8_t>& edges) {
    std::fill(depths_.begin(), depths_.end(), 0);
    std::fill(ys_.begin(), ys_.end(), 0);
    for (int row = 0; row < std::min(radius_, window_); ++row)
        add_row(depth_buffer, row, 1);
    for (int row = 0; row < window_; ++row) {
        if (row + radius_ < window_)
            add_row(depth_buffer, row + radius_, 1);
        if (row - radius_ > 0)
            add_row(depth_buffer, row - radius_ - 1, -1);
        auto const at = static_cast<std::size_t>(row) * static_cast<std::size_t>(window_);
        extract_row(depth_buffer.data() + at, row, edges.data() + at);
    }
}

/// To the sums of the columns, or from them.
void EdgeExtraction::add_row(std::vector<std::uint16_t> const& depth_buffer, int row, std::int64_t sign) {
    auto const side = static_cast<std::size_t>(window_);
    auto const at = static_cast<std::size_t>(row);
    for (std::size_t col = 0; col < side; ++col) {
        std::int64_t const depth = sign * depth_buffer[at * side + col];
        depths_[col] += depth;
        ys_[col] += depth * slope_[at];
    }
}

void EdgeExtraction::extract_row(std::uint16_t const* depth, int row, std::uint8_t* edges) const {
    std::int64_t const rows = end(row) - first(row);
    for (int col = 0; col < window_; ++col) {
        edges[col] = 0;
        if (!is_drawn(depth[col]))
            continue;
        std::int64_t const pixels = rows * (end(col) - first(col));
        if (is_edge(point(depth[col], row, col), sum_around(first(col), end(col)), pixels))
            edges[col] = 1;
    }
}

EdgeExtraction::Vector EdgeExtraction::point(std::int64_t depth, int row, int col) const {
    return {depth * slope_[static_cast<std::size_t>(col)], depth * slope_[static_cast<std::size_t>(row)],
            depth << slope_fraction};
}

EdgeExtraction::Vector EdgeExtraction::sum_around(int first_col, int end_col) const {
    Vector sum;
    for (auto col = static_cast<std::size_t>(first_col); col < static_cast<std::size_t>(end_col); ++col) {
        sum.x += depths_[col] * slope_[col];
        sum.y += ys_[col];
        sum.z += depths_[col] << slope_fraction;
    }
    return sum;
}

/// `pixels` and `sum` include the point itself, which adds nothing to the differences. A point in the camera's centre
/// has no direction, and is no edge; neither is one without neighbours.
bool EdgeExtraction::is_edge(Vector const& point, Vector const& sum, std::int64_t pixels) const {
    Vector const differences{sum.x - pixels * point.x, sum.y - pixels * point.y, sum.z - pixels * point.z};
    std::uint64_t const divisor = static_cast<std::uint64_t>(pixels - 1) * length(point);
    return divisor > 0 && (length(differences) << quotient_fraction) / divisor > threshold_code_;
}

}  // namespace faster::datapath
