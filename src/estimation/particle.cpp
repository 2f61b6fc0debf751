#include "estimation/particle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace faster::estimation {

namespace {
constexpr double nearest_origin_m = 0.1;

/// Each vertex once, the first of those that reach as far.
std::vector<Eigen::Vector3d> furthest_vertices(Mesh const& mesh) {
    constexpr int directions = 27, none = 13;  // of three values per axis, less the one that goes nowhere
    std::vector<std::size_t> furthest;
    for (int number = 0; number < directions; ++number) {
        int const column = number % 3 - 1, row = number / 3 % 3 - 1, layer = number / 9 - 1;
        double const x = column, y = row, z = layer;
        std::size_t best = 0;
        double reach = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            Eigen::Vector3d const& vertex = mesh.vertices[i];
            double const along = x * vertex.x() + y * vertex.y() + z * vertex.z();
            if (along > reach) {
                reach = along;
                best = i;
            }
        }
        if (number != none && std::find(furthest.begin(), furthest.end(), best) == furthest.end())
            furthest.push_back(best);
    }
    std::vector<Eigen::Vector3d> vertices;
    vertices.reserve(furthest.size());
    for (std::size_t const index : furthest)
        vertices.push_back(mesh.vertices[index]);
    return vertices;
}
}  // namespace

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
    size.outline = furthest_vertices(mesh);
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
