#pragma once
#include <Eigen/Core>

#include "kernel/base/counter_random.hpp"

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

}  // namespace faster::estimation
