#pragma once
#include <string>
#include <vector>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

/// A line of a plot: its values at 0, 1, 2, ...
struct PlottedLine {
    std::string name;
    std::vector<double> values;  ///< finite, from 0 up
};

/// Lines over one axis, from 0 to the largest value.
struct LinePlot {
    std::string title;
    std::string across;  ///< what the numbers 0, 1, 2, ... count
    std::vector<PlottedLine> lines;
};

/// Plots side by side, two in a row, each with a key of its lines' names and last values.
Image<Colour> drawn_plots(std::vector<LinePlot> const& plots);

/// The end of an axis that reaches `largest`, five steps of 1, 2 or 5 times a power of ten away from 0; 1 for 0.
double axis_end(double largest);

}  // namespace faster::pictures
