#include "modules/inlier_unit/hidden_pixels.hpp"

#include <algorithm>

#include "modules/inlier_unit/compared_pixels.hpp"

namespace faster::datapath {

HiddenSweep::HiddenSweep(int window, int depth_fraction)
    : side_(static_cast<std::size_t>(window)),
      near_limit_(drawn_below(depth_fraction)),
      tolerance_(tolerance_of(depth_fraction)) {}

void HiddenSweep::sweep(std::size_t first, std::size_t count, std::uint16_t const* depth_buffer,
                        std::uint16_t const* observed_depth, SampleCounters& counters) const {
    each_compared_row(side_, first, count, [&](std::size_t row, std::size_t from, std::size_t to) {
        sweep_row(row, from - row * side_, to - row * side_, depth_buffer + row * side_,
                  observed_depth + (from - first), counters);
    });
}

/// `observed` begins with `first_col`, `drawn` with the row.
void HiddenSweep::sweep_row(std::size_t row, std::size_t first_col, std::size_t end_col, std::uint16_t const* drawn,
                            std::uint16_t const* observed, SampleCounters& counters) const {
    for (std::size_t col = first_col; col < end_col; ++col) {
        unsigned const depth = drawn[col];
        if (depth >= near_limit_)
            continue;
        unsigned const reading = observed[col - first_col];
        if (reading != 0 && reading + tolerance_ < depth) {
            ++counters.hidden;
            continue;
        }
        if (counters.visible_top == 0)  // the window's border is not swept: no pixel has row or column 0
            counters.visible_top = row;
        if (counters.visible_left == 0 || col < counters.visible_left)
            counters.visible_left = col;
        counters.visible_bottom = row;
        counters.visible_right = std::max<std::uint64_t>(counters.visible_right, col);
    }
}

}  // namespace faster::datapath
