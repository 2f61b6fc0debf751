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

/// One line of the scan, as thesis 5.1 looks at it: the covered run, within a longer one that comes near the triangle,
/// around a shorter one that is too far inside to be near an edge. Pixels counted along the scan; `end`: one behind the
/// last. A run without pixels lies where the one around it ends.
struct NearEdgeLine {
    NearEdgeLine(ScanLine const& line, ScanLine const& near, ScanLine const& far_inside)
        : covered(line),
          near_first(near.before),
          near_end(near.before + near.inside),
          covered_first(std::min(line.before, near_end)),
          covered_end(covered_first + line.inside),
          far_first(std::min(far_inside.before, covered_end)),
          far_end(far_first + far_inside.inside) {}

    ScanLine covered;
    int near_first;  ///< where no edge value is below minus its threshold
    int near_end;
    int covered_first;  ///< where none is negative
    int covered_end;
    int far_first;  ///< where all are above their thresholds
    int far_end;
};

/// Walks the box of a triangle as ZigzagScan does, and finds the pixels near one of its edges (thesis 5.1): an edge
/// value is within its threshold of zero, and none is below minus its threshold, which cuts the edges off at the
/// vertices. Each of the two conditions is a larger or smaller triangle, and so a run of pixels per line.
class NearEdgeScan {
  public:
    NearEdgeScan(TriangleSetup const& setup, std::array<std::int64_t, 3> const& thresholds)
        : covered_(setup), near_(moved(setup, thresholds, 1)), far_inside_(moved(setup, thresholds, -1)) {}

    bool done() const { return covered_.done(); }
    NearEdgeLine next_line() { return {covered_.next_line(), near_.next_line(), far_inside_.next_line()}; }

  private:
    /// The triangle with its edges moved outwards by their thresholds (`sign` 1), or inwards by the smallest step more.
    static TriangleSetup moved(TriangleSetup setup, std::array<std::int64_t, 3> const& thresholds, int sign) {
        for (std::size_t i = 0; i < thresholds.size(); ++i)
            setup.edge[i].at_start += sign > 0 ? thresholds[i] : -thresholds[i] - 1;
        return setup;
    }

    ZigzagScan covered_;
    ZigzagScan near_;
    ZigzagScan far_inside_;
};

}  // namespace faster::datapath
