#pragma once
#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster::datapath {

/// The lines of the zigzag, in its order and directions, of which only the covered runs and what sends an edge token
/// take an iteration; a line that has neither takes one. Where a run begins and ends is worked out by the setup, for
/// the first row and from row to row; ZigzagScan does the same.
class SpanScan : public ZigzagScan {
  public:
    static constexpr bool skips_outside = true;
    using ZigzagScan::ZigzagScan;
};

}  // namespace faster::datapath
