#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace faster {

/// A triangle mesh in its object frame [m]. Faces list vertex indices counter-clockwise seen from outside (= front).
struct Mesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::size_t duplicates = 0;  ///< triangles that were left out on simplifying, as another is the same
};

/// Object to camera frame: p = rotation * X + translation [m]. Camera: x right, y down, z forward.
struct Pose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

}  // namespace faster
