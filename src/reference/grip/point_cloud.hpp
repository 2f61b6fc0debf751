#pragma once
#include <Eigen/Core>

#include "common/camera.hpp"
#include "common/image.hpp"
#include "common/stimulus.hpp"

namespace faster::grip {

/// What a depth camera sees: a point per pixel in the camera frame [m], row-major. z is 0 where there is none.
using PointCloud = Image<Eigen::Vector3d>;

inline bool has_point(Eigen::Vector3d const& point) { return point.z() > 0; }

/// The point at depth `z` on the ray through a pixel's centre.
Eigen::Vector3d back_projected(Camera const& camera, int row, int col, double z);

/// The observed scene. A reading stands for the middle of its depth code.
PointCloud observed_cloud(Stimulus const& stimulus);

}  // namespace faster::grip
