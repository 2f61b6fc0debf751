#include "estimation/particle.hpp"

#include <algorithm>
#include <cmath>

namespace faster::estimation {

namespace {
constexpr double nearest_origin_m = 0.1;
}

ObjectSize size_of(Mesh const& mesh) {
    ObjectSize size;
    if (mesh.vertices.empty())
        return size;
    Eigen::Vector3d least = mesh.vertices.front(), most = mesh.vertices.front();
    for (Eigen::Vector3d const& vertex : mesh.vertices) {
        least = least.cwiseMin(vertex);
        most = most.cwiseMax(vertex);
    }
    size.middle = (least + most) / 2;
    size.least_extent = (most - least).minCoeff();
    double square = 0;
    for (Eigen::Vector3d const& vertex : mesh.vertices) {
        double const x = vertex.x() - size.middle.x(), y = vertex.y() - size.middle.y();
        double const z = vertex.z() - size.middle.z();
        square = std::max(square, x * x + y * y + z * z);
    }
    size.diameter = 2 * std::sqrt(square);
    return size;
}

Pose pose_of(Particle const& particle, ObjectSize const& size) {
    Pose pose;
    pose.rotation = particle.rotation.matrix();
    Eigen::Vector3d const offset = rotated(pose.rotation, size.middle);
    for (Eigen::Index i = 0; i < 3; ++i)
        pose.translation(i) = particle.middle(i) - offset(i);
    pose.translation.z() = std::max(pose.translation.z(), nearest_origin_m);
    return pose;
}

}  // namespace faster::estimation
