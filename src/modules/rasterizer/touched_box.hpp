#pragma once
#include <algorithm>

#include "faster/data/pixel_box.hpp"

namespace faster::datapath {

/// The smallest box of a window that holds all pixels it was told of, and `margin` pixels around them: minimum and
/// maximum of rows and columns. What lies so far outside the window that its margin does not reach in counts for
/// nothing.
class TouchedBox {
  public:
    /// `window`: its side [px]
    TouchedBox(int window, int margin) : window_(window), margin_(margin) { clear(); }

    void clear() { *this = TouchedBox(window_, margin_, window_ + margin_); }

    /// Relative to the window.
    void add(int row, int col) { add_run(row, col, col); }
    /// Pixels of a row, both columns included.
    void add_run(int row, int first_col, int last_col) {
        int const first = std::max(first_col, -margin_);
        int const last = std::min(last_col, window_ + margin_ - 1);
        if (row < -margin_ || row >= window_ + margin_ || first > last)
            return;
        first_row_ = std::min(first_row_, row);
        last_row_ = std::max(last_row_, row);
        first_col_ = std::min(first_col_, first);
        last_col_ = std::max(last_col_, last);
    }

    PixelBox box() const {
        if (last_row_ < first_row_)
            return {};
        return {std::max(0, first_row_ - margin_), std::max(0, first_col_ - margin_),
                std::min(window_, last_row_ + margin_ + 1), std::min(window_, last_col_ + margin_ + 1)};
    }

  private:
    TouchedBox(int window, int margin, int beyond)
        : window_(window), margin_(margin), first_row_(beyond), first_col_(beyond) {}

    int window_;
    int margin_;
    int first_row_ = 0;
    int first_col_ = 0;
    int last_row_ = -2;  // before all pixels that count
    int last_col_ = -2;
};

}  // namespace faster::datapath
