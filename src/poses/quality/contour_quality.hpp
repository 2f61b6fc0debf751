#pragma once
#include <cstdint>

#include "faster/data/image.hpp"
#include "poses/quality/silhouette.hpp"

namespace faster::quality {

/// How well an edge map draws the contour of an object (thesis 4.2.1: "a continuous single-pixel width contour").
struct ContourQuality {
    double precision = 0;    ///< share of the edge pixels that are contour; 0 without edge pixels
    double recall = 0;       ///< share of the contour that is edge pixels; 1 without contour
    double thickness = 0;    ///< of the lines near the contour [px]; 0 without any
    bool is_closed = false;  ///< edge pixels, connected over corners, part the object from what is around it
    bool is_thin = false;    ///< no 2 x 2 block of edge pixels that is not in the contour as well

    double f1() const { return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0; }
};

/// All pictures 0 or 1, of one size. `side` says which contour of the silhouette the edge map is to draw.
ContourQuality contour_quality(Image<std::uint8_t> const& edge_map, Image<std::uint8_t> const& silhouette,
                               ContourSide side);

}  // namespace faster::quality
