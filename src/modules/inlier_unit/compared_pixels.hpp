#pragma once
#include <algorithm>
#include <cstddef>

namespace faster::datapath {

// Which pixels are compared with the observed ones, and how (docs/function.md#inlierunit): what all comparisons share.

/// 2.0 m: codes of depths with so many fractional bits below it count as drawn.
constexpr unsigned drawn_below(int depth_fraction) { return 2U << depth_fraction; }
/// 3.0 m: codes up to it count as valid, that of no reading too.
constexpr unsigned valid_up_to(int depth_fraction) { return 3U << depth_fraction; }
/// |difference| <= 1/128 m, in codes; below 7 fractional bits only equal codes are that close.
constexpr unsigned tolerance_of(int depth_fraction) { return (1U << depth_fraction) >> 7; }

/// Calls `take(row, from, to)` for the parts of rows in pixels [first, first + count) of a window that are compared, in
/// row-major order: all but the window's border. `from` and `to` are places in the window.
template <class Take> void each_compared_row(std::size_t side, std::size_t first, std::size_t count, Take take) {
    std::size_t const end = first + count;
    for (std::size_t at = first; at < end;) {
        std::size_t const row = at / side;
        std::size_t const row_end = std::min(end, (row + 1) * side);
        std::size_t const from = std::max(at, row * side + 1);
        std::size_t const to = std::min(row_end, (row + 1) * side - 1);
        if (row != 0 && row + 1 != side && from < to)
            take(row, from, to);
        at = row_end;
    }
}

}  // namespace faster::datapath
