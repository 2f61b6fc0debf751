#include "modules/rasterizer/triangle_setup.hpp"

#include <algorithm>

namespace faster::datapath {

namespace {

/// E_ab at (x, y), all in codes.
std::int64_t orientation(VertexCode const& a, VertexCode const& b, std::int64_t x, std::int64_t y) {
    return (x - a.x) * (b.y - a.y) - (std::int64_t{b.x} - a.x) * (y - a.y);
}

EdgeFunction edge_function(VertexCode const& a, VertexCode const& b, int start_col, int start_row, int xy_fraction) {
    std::int64_t const pixel = std::int64_t{1} << xy_fraction;
    EdgeFunction edge;
    edge.at_start = orientation(a, b, start_col * pixel, start_row * pixel);
    edge.per_column = (std::int64_t{b.y} - a.y) * pixel;
    edge.per_row = -(std::int64_t{b.x} - a.x) * pixel;
    return edge;
}

VertexCode const& topmost(VertexCode const (&v)[3]) {
    VertexCode const* top = &v[0];
    for (int i = 1; i < 3; ++i)
        if (v[i].y < top->y)
            top = &v[i];
    return *top;
}

}  // namespace

TriangleSetup set_up(TriangleCode const& triangle, int image_width, int image_height, int xy_fraction) {
    VertexCode const(&v)[3] = triangle.vertex;
    auto const [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
    auto const [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
    // Right shifts of negative codes round down, as the bounds must.
    int const col_min = x_min >> xy_fraction, col_max = x_max >> xy_fraction;
    int const row_min = y_min >> xy_fraction, row_max = y_max >> xy_fraction;
    TriangleSetup setup;
    if (col_min < 0 || row_min < 0 || col_max >= image_width || row_max >= image_height)
        return setup;
    setup.area = orientation(v[0], v[1], v[2].x, v[2].y);
    if (!setup.drawn())
        return setup;
    VertexCode const& start = topmost(v);
    setup.left_wall = col_min;
    setup.right_wall = col_max + 1;
    setup.bottom = row_max;
    setup.start_row = start.y >> xy_fraction;
    setup.start_col = start.x >> xy_fraction;
    for (int i = 0; i < 3; ++i) {
        setup.edge[i] = edge_function(v[(i + 1) % 3], v[(i + 2) % 3], setup.start_col, setup.start_row, xy_fraction);
        setup.z[i] = v[i].z;
    }
    return setup;
}

}  // namespace faster::datapath
