#include "workload/pictures/contact_layout.hpp"

#include <algorithm>
#include <cmath>

namespace faster::pictures {

namespace {

constexpr int largest_thumb = 200;
constexpr int smallest_thumb = 40;

/// Columns that make the cells an area about as wide as 4 : 3.
int columns_for(ContactLayout const& layout) {
    double const cell_ratio = static_cast<double>(layout.cell_height()) / layout.cell_width();
    double const columns = std::sqrt(static_cast<double>(layout.cells) * cell_ratio * 4 / 3);
    int const fitting = ContactLayout::longest_side / layout.cell_width();
    return static_cast<int>(std::clamp<double>(std::ceil(columns), 1, fitting));
}

std::size_t most_cells(ContactLayout const& layout) {
    int const columns = ContactLayout::longest_side / layout.cell_width();
    int const rows = ContactLayout::longest_side / layout.cell_height();
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

}  // namespace

ContactLayout contact_layout(std::size_t cells) {
    ContactLayout layout;
    layout.thumb = smallest_thumb;
    layout.cells = std::min(cells, most_cells(layout));
    for (layout.thumb = largest_thumb; layout.thumb >= smallest_thumb; --layout.thumb) {
        layout.columns = columns_for(layout);
        if (layout.height() <= ContactLayout::longest_side)
            return layout;
    }
    layout.thumb = smallest_thumb;
    layout.columns = ContactLayout::longest_side / layout.cell_width();
    return layout;
}

}  // namespace faster::pictures
