#include "faster/workload/pictures/depth_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

namespace {

std::array<Colour, DepthScale::shades> make_viridis() {
    cv::Mat levels(1, DepthScale::shades, CV_8UC1);
    for (int i = 0; i < DepthScale::shades; ++i)
        levels.at<std::uint8_t>(0, i) = static_cast<std::uint8_t>(DepthScale::shades - 1 - i);  // the far end is dark
    cv::Mat colours;
    cv::applyColorMap(levels, colours, cv::COLORMAP_VIRIDIS);
    std::array<Colour, DepthScale::shades> table;
    for (int i = 0; i < DepthScale::shades; ++i) {
        auto const& c = colours.at<cv::Vec3b>(0, i);
        table[static_cast<std::size_t>(i)] = {c[2], c[1], c[0]};  // OpenCV keeps blue first
    }
    return table;
}

}  // namespace

Colour viridis(int shade) {
    static std::array<Colour, DepthScale::shades> const table = make_viridis();
    return table[static_cast<std::size_t>(shade)];
}

void DepthScale::include(Image<std::uint16_t> const& depth_buffer) {
    for (std::uint16_t const code : depth_buffer.pixels())
        if (code < far_depth_code) {
            nearest_ = std::min<int>(nearest_, code);
            farthest_ = std::max<int>(farthest_, code);
        }
}

int DepthScale::first() const {
    int const missing = std::max(0, fewest_codes - (farthest_ - nearest_));
    return std::max(0, nearest_ - missing / 2);
}

int DepthScale::last() const { return std::max(farthest_, first() + fewest_codes); }

double DepthScale::metres(int code) const { return std::ldexp(code, -fraction_bits_); }

int DepthScale::shade(std::uint16_t code) const {
    int const beyond_first = std::clamp<int>(code, first(), last()) - first();
    return beyond_first * (shades - 1) / (last() - first());
}

Colour DepthScale::colour(std::uint16_t code) const {
    return code >= far_depth_code ? palette::nothing_drawn : viridis(shade(code));
}

double DepthScale::position(double depth_metres) const {
    return (depth_metres - nearest_metres()) / (farthest_metres() - nearest_metres());
}

/// 1, 2 or 5 times a power of ten, so that three to nine ticks fit.
double DepthScale::tick_step() const {
    double const length = farthest_metres() - nearest_metres();
    double const decade = std::pow(10.0, std::floor(std::log10(length)) - 1);
    for (double const factor : {2.0, 5.0, 10.0})
        if (length <= 8 * factor * decade)
            return factor * decade;
    return 20 * decade;
}

std::vector<double> DepthScale::ticks() const {
    double const step = tick_step();
    std::vector<double> depths;
    auto const end = std::floor(farthest_metres() / step);
    for (double i = std::ceil(nearest_metres() / step); i <= end; ++i)
        depths.push_back(i * step);
    return depths;
}

std::string DepthScale::label(double depth_metres) const {
    int const decimals = std::max(0, static_cast<int>(-std::floor(std::log10(tick_step()) + 1e-9)));
    return fmt::format("{:.{}f} m", depth_metres, decimals);
}

}  // namespace faster::pictures
