#pragma once
#include <cstdint>

#include "faster/data/image.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/data/tokens.hpp"

namespace faster::reference {

/// Where a window lies in the image: its top left pixel, which may be outside. Wide enough for any sample's centre.
struct WindowOffset {
    std::int64_t row = 0;
    std::int64_t col = 0;
};

/// The observed images as one window sees them, W x W.
struct ObservedWindow {
    Image<std::uint16_t> depth;  ///< codes, 0 = no reading or outside the image
    Image<std::uint8_t> edges;   ///< 0 or 1, 0 outside the image
};

/// Fills `observed`, already W x W, from the images of `stimulus`.
void read_window(Stimulus const& stimulus, WindowOffset offset, ObservedWindow& observed);

/// What an edge pixel is compared with: the depth of a neighbour, as it lies outside the object (thesis A.3), or what
/// is drawn there, as it lies on its border (thesis 7.2).
enum class EdgeDepth { of_neighbour, of_pixel };

/// Compares what was drawn with what was observed, pixel by pixel without the border of the window (thesis A.3,
/// docs/function.md#inlierunit). Adds to every counter but valid_raster and
/// those of count_hidden(). `maps` and `observed` are W x W.
void sweep(SampleMaps const& maps, ObservedWindow const& observed, int depth_fraction_bits, EdgeDepth edge_depth,
           SampleCounters& counters);

/// Which of the drawn pixels something nearer hides, and the box of all others (docs/function.md#hidden-pixels).
void count_hidden(Image<std::uint16_t> const& depth_buffer, Image<std::uint16_t> const& observed_depth,
                  int depth_fraction_bits, SampleCounters& counters);

}  // namespace faster::reference
