#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "common/mesh.hpp"
#include "estimation/rotation.hpp"

namespace faster::estimation {

/// A sample of the loop: where the object's middle is, and how it is turned about it. The middle, that of the mesh's
/// box, rather than the origin: noise of one does then not move the other, wherever the mesh has its origin.
struct Particle {
    Rotation rotation;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< in the camera frame [m]
    std::size_t box = 0;                               ///< index of the detection it began in
};

/// What the loop knows of the object's shape.
struct ObjectSize {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< of its box, in the object frame [m]
    double least_extent = 0;                           ///< of its box [m]
    double diameter = 0;                               ///< of the ball around that middle that holds it [m]
    /// The vertices that reach furthest in 26 directions, towards faces, edges and corners of the box: a few that tell
    /// about what the object covers.
    std::vector<Eigen::Vector3d> outline;
};
ObjectSize size_of(Mesh const& mesh);

/// The pose of a particle. Its origin is at least 0.1 m before the camera, as sample headers need it (SPEC section 2):
/// one that is nearer is moved there along the camera's axis.
Pose pose_of(Particle const& particle, ObjectSize const& size);

}  // namespace faster::estimation
