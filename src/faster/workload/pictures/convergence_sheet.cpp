#include "faster/workload/pictures/convergence_sheet.hpp"

#include <algorithm>

#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/drawing.hpp"

namespace faster::pictures {

namespace {

constexpr int cell_side = 402;
constexpr int cell_gap = 10;
constexpr int label_height = 24;
constexpr int most_columns = 4;

}  // namespace

ConvergenceSheet::ConvergenceSheet(std::size_t cells)
    : columns_(std::clamp(static_cast<int>(cells), 1, most_columns)),
      canvas_((static_cast<int>(cells) + columns_ - 1) / columns_ * (cell_side + label_height + cell_gap) + cell_gap,
              columns_ * (cell_side + cell_gap) + cell_gap, palette::paper) {}

void ConvergenceSheet::add(std::string const& label, Image<Colour> const& picture) {
    int const top = cell_gap + used_ / columns_ * (cell_side + label_height + cell_gap);
    int const left = cell_gap + used_ % columns_ * (cell_side + cell_gap);
    write_text(canvas_, label, top + label_height - 8, left, 0.45);
    Image<Colour> const fitted = fitted_square(picture, cell_side - 2);
    fill(canvas_, {top + label_height, left, fitted.height() + 2, fitted.width() + 2}, palette::nothing_drawn);
    paste(canvas_, fitted, top + label_height + 1, left + 1);
    ++used_;
}

}  // namespace faster::pictures
