#pragma once
#include <Eigen/Core>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::models {

/// All parts in one mesh, each remaining a closed component of its own; parts may run into each other.
Mesh joined(std::vector<Mesh> const& parts);

/// Turned about the z axis, counter-clockwise seen from above.
Mesh turned_about_z(Mesh mesh, double degrees);

/// Moved and scaled along each axis so that the bounding box has this size and its centre is the origin.
Mesh fitted(Mesh mesh, Eigen::Vector3d const& size);

}  // namespace faster::models
