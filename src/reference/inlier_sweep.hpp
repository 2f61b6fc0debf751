#pragma once
#include "common/stimulus.hpp"
#include "common/tokens.hpp"
#include "reference/observed_window.hpp"

namespace faster::reference {

/// What an edge pixel is compared with: the depth of a neighbour, as it lies outside the object (thesis A.3), or what
/// is drawn there, as it lies on its border (thesis 7.2).
enum class EdgeDepth { of_neighbour, of_pixel };

/// Compares what was drawn with what was observed, pixel by pixel without the border of the window (SPEC section 2,
/// InlierUnit; thesis A.3). Adds to every counter but valid_raster. `maps` and `observed` are W x W.
void sweep(SampleMaps const& maps, ObservedWindow const& observed, int depth_fraction_bits, EdgeDepth edge_depth,
           SampleCounters& counters);

}  // namespace faster::reference
