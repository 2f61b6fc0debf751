#pragma once
#include <Eigen/Core>

#include "faster/data/mesh.hpp"

namespace faster::models {

/// A box with sharp edges around the origin, every face a grid of squares of about `edge_length` cut in two [mm].
Mesh box(Eigen::Vector3d const& size, double edge_length);

}  // namespace faster::models
