#pragma once
#include <cstdint>

#include "faster/data/tokens.hpp"

namespace faster::datapath {

/// One edge function on whole pixels: its value at the start pixel and its change per column and row (thesis eq. 2.6).
struct EdgeFunction {
    std::int64_t at_start = 0;
    std::int64_t per_column = 0;
    std::int64_t per_row = 0;
};

/// What the rasterizer works out before it scans a triangle (docs/function.md#rasterizer, steps 1 and 2; thesis A.1).
struct TriangleSetup {
    std::int64_t area = 0;  ///< what goes to AreaReciprocal: E_01(V2), or 0 for a rejected triangle
    int left_wall = 0;      ///< columns and rows of the image [px]
    int right_wall = 0;
    int bottom = 0;
    int start_row = 0;
    int start_col = 0;
    EdgeFunction edge[3];  ///< E_12, E_20, E_01: the weights of vertices 0, 1, 2
    std::int64_t z[3] = {0, 0, 0};

    bool drawn() const { return area > 0; }
    bool starts_inside() const { return (edge[0].at_start | edge[1].at_start | edge[2].at_start) >= 0; }
};

/// `xy_fraction`: fractional bits of x and y. Only `area` is set unless the triangle is drawn.
TriangleSetup set_up(TriangleCode const& triangle, int image_width, int image_height, int xy_fraction);

}  // namespace faster::datapath
