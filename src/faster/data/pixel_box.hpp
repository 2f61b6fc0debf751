#pragma once
#include <algorithm>

#include "faster/data/tokens.hpp"

namespace faster {

/// A rectangle of pixels; empty unless the ends lie beyond the firsts.
struct PixelBox {
    int first_row = 0;
    int first_col = 0;
    int end_row = 0;
    int end_col = 0;

    int rows() const { return std::max(0, end_row - first_row); }
    int cols() const { return std::max(0, end_col - first_col); }
    bool empty() const { return rows() == 0 || cols() == 0; }
};

/// As two tokens: its first pixel and its last. Those of an empty box are (0, 0) and (-1, -1).
struct Corners {
    FragmentIndex first;
    FragmentIndex last;
};

inline Corners corners_of(PixelBox const& box) {
    if (box.empty())
        return {{0, 0}, {-1, -1}};
    auto const pixel = [](int row, int col) {
        return FragmentIndex{static_cast<std::int16_t>(row), static_cast<std::int16_t>(col)};
    };
    return {pixel(box.first_row, box.first_col), pixel(box.end_row - 1, box.end_col - 1)};
}

inline PixelBox box_of(Corners const& corners) {
    return {corners.first.row, corners.first.col, corners.last.row + 1, corners.last.col + 1};
}

}  // namespace faster
