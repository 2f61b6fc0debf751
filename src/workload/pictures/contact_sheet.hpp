#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/image.hpp"
#include "workload/pictures/colour.hpp"
#include "workload/pictures/contact_layout.hpp"
#include "workload/pictures/depth_scale.hpp"

namespace faster::pictures {

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
