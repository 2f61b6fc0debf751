#pragma once
#include <vector>

#include "common/mesh.hpp"

namespace faster::models {

/// A level super-ellipse of a loft [mm]. Exponent 2 is an ellipse, 4 to 8 a rounded rectangle.
struct Level {
    double height;
    double half_x;
    double half_y;
    double exponent = 2.0;
    double centre_x = 0.0;
};

/// The body through all levels, from bottom to top, with flat ends.
Mesh loft(std::vector<Level> const& levels, double edge_length);

}  // namespace faster::models
