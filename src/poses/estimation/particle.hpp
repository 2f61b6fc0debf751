#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "dataflow/base/counter_random.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::estimation {

/// A rotation as a unit quaternion, of either sign. Spelled out, so that every machine computes the same bits: Eigen
/// leaves the order of sums, and whether they are fused, to the compiler and the processor.
struct Rotation {
    double w = 1, x = 0, y = 0, z = 0;

    Eigen::Matrix3d matrix() const;
};

/// First `b`, then `a`.
Rotation product(Rotation const& a, Rotation const& b);
Rotation normalized(Rotation const& rotation);
/// Between two rotations [rad], 0 to pi.
double angle_between(Rotation const& a, Rotation const& b);
/// Cosine of half that angle, with the sign that the quaternions have to each other.
double dot(Rotation const& a, Rotation const& b);
/// Of a rotation matrix.
Rotation rotation_of(Eigen::Matrix3d const& matrix);
/// Rotates a vector: the sums row by row, left to right.
Eigen::Vector3d rotated(Eigen::Matrix3d const& rotation, Eigen::Vector3d const& vector);

/// Uniform on SO(3): a point that is uniform on the sphere of unit quaternions (Marsaglia, "Choosing a point from the
/// surface of a sphere", 1972).
Rotation uniform_rotation(CounterRandom& random);

/// A turn by a normal angle of deviation `sigma` [rad] about an axis of uniform direction.
Rotation random_turn(CounterRandom& random, double sigma);

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

/// The pose of a particle. Its origin is at least 0.1 m before the camera, as sample headers need it
/// (docs/function.md#samples-and-cores): one that is nearer is moved there along the camera's axis.
Pose pose_of(Particle const& particle, ObjectSize const& size);

}  // namespace faster::estimation
