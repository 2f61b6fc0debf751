#include "modules/inlier_unit/window_sweep.hpp"

#include <algorithm>
#include <cstring>

#include "faster/data/fixed_point.hpp"
#include "modules/inlier_unit/compared_pixels.hpp"

namespace faster::datapath {

WindowSweep::WindowSweep(int window, int depth_fraction, ContourDepth contour_depth)
    : window_(window),
      contour_depth_(contour_depth),
      near_limit_(drawn_below(depth_fraction)),
      valid_limit_(valid_up_to(depth_fraction)),
      tolerance_(tolerance_of(depth_fraction)) {}

bool WindowSweep::agrees(unsigned depth, unsigned observed) const {
    return depth < near_limit_ && (depth > observed ? depth - observed : observed - depth) <= tolerance_;
}

void WindowSweep::sweep(std::size_t first, std::size_t count, std::uint16_t const* depth_buffer,
                        std::uint8_t const* edge, std::uint16_t const* observed_depth,
                        std::uint8_t const* observed_edge, SampleCounters& counters) const {
    each_compared_row(static_cast<std::size_t>(window_), first, count,
                      [&](std::size_t /*row*/, std::size_t from, std::size_t to) {
                          sweep_row(to - from, depth_buffer + from, edge + (from - first),
                                    observed_depth + (from - first), observed_edge + (from - first), counters);
                      });
}

/// Counts every pixel as if it were no edge, which vectorizes, and corrects the few that are.
void WindowSweep::sweep_row(std::size_t count, std::uint16_t const* depth, std::uint8_t const* edge,
                            std::uint16_t const* observed, std::uint8_t const* observed_edge,
                            SampleCounters& counters) const {
    constexpr std::size_t block = 64;  // few enough for the 16-bit sums
    auto const near_limit = static_cast<std::uint16_t>(std::min(near_limit_, 0xffffU));
    auto const valid_limit = static_cast<std::uint16_t>(std::min(valid_limit_, 0xffffU));
    auto const tolerance = static_cast<std::uint16_t>(tolerance_);
    for (std::size_t start = 0; start < count; start += block) {
        std::size_t const stop = std::min(count, start + block);
        std::uint16_t inliers = 0;
        std::uint16_t valid = 0;
        std::uint16_t edges = 0;
        for (std::size_t i = start; i < stop; ++i) {
            std::uint16_t const z = depth[i];
            std::uint16_t const o = observed[i];
            auto const distance = static_cast<std::uint16_t>(z > o ? z - o : o - z);
            inliers =
                static_cast<std::uint16_t>(inliers + ((z < near_limit) & (distance <= tolerance) & (edge[i] == 0)));
            valid = static_cast<std::uint16_t>(valid + (o <= valid_limit));
            edges = static_cast<std::uint16_t>(edges + edge[i]);
        }
        counters.inlier += inliers;
        counters.valid_depth += valid;
        counters.valid_edge += edges;
        for (std::size_t at = start; edges != 0; ++at, --edges) {
            at =
                static_cast<std::size_t>(static_cast<std::uint8_t const*>(std::memchr(edge + at, 1, stop - at)) - edge);
            count_edge(depth + at, observed[at], observed_edge[at] != 0, counters);
        }
    }
}

/// Beside the object a contour pixel takes the depth of the first neighbour that is drawn, or 0.
unsigned WindowSweep::depth_of_edge(std::uint16_t const* depth) const {
    if (contour_depth_ == ContourDepth::own)
        return *depth;
    for (std::ptrdiff_t const offset :
         {std::ptrdiff_t{window_}, std::ptrdiff_t{-window_}, std::ptrdiff_t{1}, std::ptrdiff_t{-1}})
        if (depth[offset] < near_limit_)
            return depth[offset];
    return 0;
}

void WindowSweep::count_edge(std::uint16_t const* depth, unsigned observed, bool observed_edge,
                             SampleCounters& counters) const {
    if (!agrees(depth_of_edge(depth), observed))
        return;
    counters.inlier += 1;
    counters.edge_inlier += observed_edge ? 1 : 0;
}

}  // namespace faster::datapath
