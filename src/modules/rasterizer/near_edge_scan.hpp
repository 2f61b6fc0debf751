#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster::datapath {

/// Thresholds in px^2 as codes of edge values.
inline std::array<std::int64_t, 3> threshold_codes(std::array<double, 3> const& thresholds, int xy_fraction) {
    // Beyond all edge values of 16-bit vertices, and far from overflow.
    constexpr double largest = std::int64_t{1} << 36;
    std::array<std::int64_t, 3> codes{};
    for (std::size_t i = 0; i < codes.size(); ++i)
        codes[i] = static_cast<std::int64_t>(std::min(largest, std::floor(std::ldexp(thresholds[i], 2 * xy_fraction))));
    return codes;
}

/// Pixels of a line that are equal in what they send, counted along the scan.
struct Stretch {
    int first = 0;
    int end = 0;             ///< one behind the last
    bool is_inside = false;  ///< covered by the triangle
    bool is_near = false;    ///< near one of its edges
};

/// One line of the scan, as thesis 5.1 looks at it.
struct NearEdgeLine {
    ScanLine inside;  ///< where no edge value is negative
    ScanLine reach;   ///< where none is below minus its threshold
    ScanLine beyond;  ///< where all are above their thresholds: too far inside

    Stretch stretch_from(int pixel) const {
        Stretch stretch{pixel, inside.pixels(), false, false};
        stretch.is_inside = look(inside, stretch);
        bool const within_reach = look(reach, stretch);
        bool const is_beyond = look(beyond, stretch);
        stretch.is_near = within_reach && !is_beyond;
        return stretch;
    }

  private:
    /// Whether the stretch begins in the run of `line`; ends it where that changes. Without branches, which nothing
    /// could foresee.
    static bool look(ScanLine const& line, Stretch& stretch) {
        int const run_end = line.before + line.inside;
        for (int const change : {line.before, run_end})
            stretch.end = std::min(stretch.end, change > stretch.first ? change : stretch.end);
        return ((stretch.first >= line.before) & (stretch.first < run_end)) != 0;
    }
};

/// Walks the box of a triangle as ZigzagScan does, and finds the pixels near one of its edges (thesis 5.1): an edge
/// value is within its threshold of zero, and none is below minus its threshold, which cuts the edges off at the
/// vertices. Each of the two conditions is a larger or smaller triangle, and so a run of pixels per line.
class NearEdgeScan {
  public:
    NearEdgeScan(TriangleSetup const& setup, std::array<std::int64_t, 3> const& thresholds)
        : inside_(setup), reach_(moved(setup, thresholds, 1)), beyond_(moved(setup, thresholds, -1)) {}

    bool done() const { return inside_.done(); }
    NearEdgeLine next_line() { return {inside_.next_line(), reach_.next_line(), beyond_.next_line()}; }

  private:
    /// The triangle with its edges moved outwards by their thresholds (`sign` 1), or inwards by the smallest step more.
    static TriangleSetup moved(TriangleSetup setup, std::array<std::int64_t, 3> const& thresholds, int sign) {
        for (std::size_t i = 0; i < thresholds.size(); ++i)
            setup.edge[i].at_start += sign > 0 ? thresholds[i] : -thresholds[i] - 1;
        return setup;
    }

    ZigzagScan inside_;
    ZigzagScan reach_;
    ZigzagScan beyond_;
};

}  // namespace faster::datapath
