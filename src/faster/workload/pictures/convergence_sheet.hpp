#pragma once
#include <cstddef>
#include <string>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

/// Square pictures side by side, each below a line of text, row by row: thesis fig. 4.4.
class ConvergenceSheet {
  public:
    /// For `cells` pictures.
    explicit ConvergenceSheet(std::size_t cells);

    /// Draws the next cell.
    void add(std::string const& label, Image<Colour> const& picture);

    Image<Colour> const& picture() const { return canvas_; }

  private:
    int columns_;
    Image<Colour> canvas_;
    int used_ = 0;
};

}  // namespace faster::pictures
