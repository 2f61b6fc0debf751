#pragma once
#include <cstdint>

#include "faster/data/image.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

/// What the observation holds in a sample's window (0 or 1), nothing where the window leaves the image.
Image<std::uint8_t> observed_edges_in_window(Stimulus const& stimulus, SampleInput const& sample);

/// Edge map (red) over object map (green) over observed edges (blue), on white; an edge pixel that is observed as well
/// is purple. One pixel per window pixel. All three maps: zero or not, of the same size.
Image<Colour> overlay(Image<std::uint8_t> const& edge_map, Image<std::uint8_t> const& object_map,
                      Image<std::uint8_t> const& observed_edges);

}  // namespace faster::pictures
