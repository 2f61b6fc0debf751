#pragma once
#include <cstdint>

#include "common/image.hpp"
#include "common/stimulus.hpp"

namespace faster::reference {

/// Where a window lies in the image: its top left pixel, which may be outside. Wide enough for any sample's centre.
struct WindowOffset {
    std::int64_t row = 0;
    std::int64_t col = 0;
};

/// Offset of the W x W window around a sample: its centre - W / 2 (SPEC section 2, sample header).
WindowOffset window_offset(SampleInput const& sample, int window);

/// The observed images as one window sees them, W x W.
struct ObservedWindow {
    Image<std::uint16_t> depth;  ///< codes, 0 = no reading or outside the image
    Image<std::uint8_t> edges;   ///< 0 or 1, 0 outside the image
};

/// Fills `observed`, already W x W, from the images of `stimulus`.
void read_window(Stimulus const& stimulus, WindowOffset offset, ObservedWindow& observed);

}  // namespace faster::reference
