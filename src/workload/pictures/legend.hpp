#pragma once
#include <string>

#include "common/image.hpp"
#include "workload/pictures/colour.hpp"
#include "workload/pictures/depth_scale.hpp"

namespace faster::pictures {

/// What the colours of overlay and depth map mean, `width` pixels wide and as high as it takes. The last thing
/// it says is `note`, if not empty. Text that does not fit into 400 px is cut off.
Image<Colour> legend(int width, DepthScale const& scale, std::string const& note);

}  // namespace faster::pictures
