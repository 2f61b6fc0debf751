#pragma once
#include <cstdint>
#include <vector>

#include "faster/data/image.hpp"
#include "faster/data/stimulus.hpp"

namespace faster::quality {

/// The pixels of a sample's W x W window that its triangles cover, 0 or 1: what edge maps are judged by. Every pixel is
/// tested against every triangle that is drawn (docs/function.md#rasterizer, step 1), without a scan.
Image<std::uint8_t> silhouette(std::vector<TriangleCode> const& triangles, Stimulus const& stimulus,
                               SampleInput const& sample);

/// On which side of the silhouette's outline a contour runs, touching the other side with a pixel's edge: around it, as
/// thesis A.2 has it, or within it (thesis 7.2).
enum class ContourSide { outside, inside };

/// The contour of a silhouette, 0 or 1. Where the window cuts the object there is none.
Image<std::uint8_t> contour_of(Image<std::uint8_t> const& silhouette, ContourSide side);

}  // namespace faster::quality
