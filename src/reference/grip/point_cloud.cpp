#include "reference/grip/point_cloud.hpp"

#include <algorithm>
#include <cmath>

namespace faster::grip {

namespace {

constexpr double nearest_m = 0.1;

/// A triangle as a lattice: `steps` along two of its sides.
void add_lattice(Eigen::Vector3d const& a, Eigen::Vector3d const& b, Eigen::Vector3d const& c, double spacing,
                 std::vector<Eigen::Vector3d>& points) {
    double const longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    int const steps = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
            points.push_back(a + (b - a) * (static_cast<double>(i) / steps) +
                             (c - a) * (static_cast<double>(j) / steps));
}

double radius_of(Mesh const& mesh) {
    double radius = 0;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        radius = std::max(radius, vertex.norm());
    return radius;
}

}  // namespace

Eigen::Vector3d back_projected(Camera const& camera, int row, int col, double z) {
    return {(col - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z};
}

PointCloud observed_cloud(Stimulus const& stimulus) {
    PointCloud cloud(stimulus.height, stimulus.width, Eigen::Vector3d::Zero());
    for (int row = 0; row < stimulus.height; ++row)
        for (int col = 0; col < stimulus.width; ++col)
            if (int const code = stimulus.observed_depth.at(row, col); code > 0)
                cloud.at(row, col) = back_projected(stimulus.posed.camera, row, col,
                                                    std::ldexp(code + 0.5, -stimulus.fraction.depth_buffer));
    return cloud;
}

std::vector<Eigen::Vector3d> surface_points(Mesh const& mesh, double spacing) {
    std::vector<Eigen::Vector3d> points;
    for (auto const& [a, b, c] : mesh.faces)
        add_lattice(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], spacing, points);
    return points;
}

PointCloud render(std::vector<Eigen::Vector3d> const& points, Pose const& pose, Camera const& camera) {
    PointCloud cloud(camera.height, camera.width, Eigen::Vector3d::Zero());
    for (Eigen::Vector3d const& point : points) {
        Eigen::Vector3d const seen = pose.rotation * point + pose.translation;
        if (seen.z() < nearest_m)
            continue;
        double const col = std::round(camera.fx * seen.x() / seen.z() + camera.cx);
        double const row = std::round(camera.fy * seen.y() / seen.z() + camera.cy);
        if (!(col >= 0 && row >= 0 && col < camera.width && row < camera.height))
            continue;
        Eigen::Vector3d& nearest = cloud.at(static_cast<int>(row), static_cast<int>(col));
        if (!has_point(nearest) || seen.z() < nearest.z())
            nearest = back_projected(camera, static_cast<int>(row), static_cast<int>(col), seen.z());
    }
    return cloud;
}

double half_pixel_spacing(PosedMesh const& posed) {
    double const radius = radius_of(posed.mesh);
    double nearest = 4;
    for (Pose const& pose : posed.poses)
        nearest = std::min(nearest, pose.translation.z() - radius);
    return 0.5 * std::max(nearest, nearest_m) / std::max(posed.camera.fx, posed.camera.fy);
}

}  // namespace faster::grip
