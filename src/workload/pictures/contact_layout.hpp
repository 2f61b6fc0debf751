#pragma once
#include <cstddef>

namespace faster::pictures {

/// Where the cells of a contact sheet are: each has a line of text and below it two square pictures. All lengths in
/// pixels. The more cells there are, the smaller they are, so that no side of their grid exceeds `longest_side`.
struct ContactLayout {
    static constexpr int longest_side = 3900;
    static constexpr int gap = 8;     ///< between pictures and around them
    static constexpr int label = 20;  ///< height of a cell's line of text

    std::size_t cells = 0;  ///< on the sheet; fewer than asked for where they would be too small to see (thousands)
    int thumb = 0;          ///< side of one picture
    int columns = 0;        ///< cells side by side

    int rows() const { return (static_cast<int>(cells) + columns - 1) / columns; }
    int cell_width() const { return 2 * thumb + 3 * gap; }
    int cell_height() const { return label + thumb + gap; }
    int width() const { return columns * cell_width(); }
    int height() const { return rows() * cell_height(); }

    int cell_top(std::size_t cell) const { return static_cast<int>(cell) / columns * cell_height(); }
    int cell_left(std::size_t cell) const { return static_cast<int>(cell) % columns * cell_width(); }
};

/// For at least one cell.
ContactLayout contact_layout(std::size_t cells);

}  // namespace faster::pictures
