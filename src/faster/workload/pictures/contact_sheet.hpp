#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/depth_scale.hpp"

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

/// Overlay and depth map of many samples on one picture: side by side, labelled with sample and inliers, below a
/// legend. No side is longer than 4000 px.
class ContactSheet {
  public:
    /// For `samples` cells, at least one; all depth maps have the colours of `scale`.
    ContactSheet(std::size_t samples, DepthScale const& scale);

    /// Cells left. The first thousands of samples fit.
    std::size_t room() const { return layout_.cells - used_; }
    /// Draws the next cell. `overlay` and `depth_buffer` have one pixel per window pixel.
    void add(std::size_t sample, std::uint64_t inliers, Image<Colour> const& overlay,
             Image<std::uint16_t> const& depth_buffer);

    Image<Colour> const& picture() const { return canvas_; }

  private:
    DepthScale scale_;
    ContactLayout layout_;
    Image<Colour> canvas_;
    int header_ = 0;  // height of the legend [px]
    std::size_t used_ = 0;
};

}  // namespace faster::pictures
