#pragma once
#include <cstdint>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/depth_scale.hpp"

namespace faster::pictures {

/// The depth buffer in the colours of a scale, grey where nothing is drawn. One pixel per window pixel.
Image<Colour> depth_map(Image<std::uint16_t> const& depth_buffer, DepthScale const& scale);

/// `picture`, with the scale as an upright bar on its right: near on top, labelled in metres.
Image<Colour> with_scale_bar(Image<Colour> const& picture, DepthScale const& scale);

}  // namespace faster::pictures
