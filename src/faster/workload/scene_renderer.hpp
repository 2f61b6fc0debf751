#pragma once
#include <Eigen/Core>

#include "faster/data/camera.hpp"
#include "faster/data/mesh.hpp"
#include "faster/workload/depth_image.hpp"

namespace faster::workload {

/// An endless plane in the camera frame.
struct Plane {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;  ///< of any length
};

/// Draw what a pinhole depth camera would see into `depth`, which has the camera's size: the nearest surface wins, both
/// sides of a surface are visible. Each pixel's ray is intersected in double precision; nothing here is shared with the
/// rasterizer under test. Surfaces may reach behind the camera. Throws Interrupted as give_up_if_interrupted() does.
void draw_mesh(Mesh const& mesh, Pose const& pose, Camera const& camera, DepthImage& depth);
void draw_plane(Plane const& plane, Camera const& camera, DepthImage& depth);

}  // namespace faster::workload
