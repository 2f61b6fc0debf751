#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "common/camera.hpp"
#include "common/image.hpp"
#include "common/mesh.hpp"
#include "common/stimulus.hpp"

namespace faster::grip {

/// What a depth camera sees: a point per pixel in the camera frame [m], row-major. z is 0 where there is none.
using PointCloud = Image<Eigen::Vector3d>;

inline bool has_point(Eigen::Vector3d const& point) { return point.z() > 0; }

/// The point at depth `z` on the ray through a pixel's centre.
Eigen::Vector3d back_projected(Camera const& camera, int row, int col, double z);

/// The observed scene. A reading stands for the middle of its depth code.
PointCloud observed_cloud(Stimulus const& stimulus);

/// Points all over the mesh's surface, `spacing` [m] apart or closer, corners and edges included.
std::vector<Eigen::Vector3d> surface_points(Mesh const& mesh, double spacing);

/// Renders an object's surface points under a pose: each is projected to the pixel around it, whose point has the depth
/// of the nearest of them. Points nearer than 0.1 m, behind the camera or outside the image are left out.
PointCloud render(std::vector<Eigen::Vector3d> const& points, Pose const& pose, Camera const& camera);

/// How far apart surface points may be so that, under all poses, neighbours are at most half a pixel apart in the
/// image.
double half_pixel_spacing(PosedMesh const& posed);

}  // namespace faster::grip
