#include "modules/vertex_transform/project_vertices.hpp"

#include <cmath>
#include <limits>

namespace faster::datapath {

namespace {

constexpr double nearest_m = 0.1;
constexpr double farthest_m = 3.99;

template <class Code> bool fits(double code) {
    return code >= std::numeric_limits<Code>::min() && code <= std::numeric_limits<Code>::max();
}

TriangleCode rejected() {
    VertexCode const vertex{rejected_vertex_code, rejected_vertex_code, 0};
    return {{vertex, vertex, vertex}};
}

}  // namespace

ProjectedVertex project(Eigen::Vector3d const& point, Pose const& pose, Camera const& camera,
                        FractionBits const& bits) {
    auto const& r = pose.rotation;
    auto const& t = pose.translation;
    // Spelled out, left to right: the order of the sums is that of docs/function.md#vertex-transform.
    double const x = r(0, 0) * point.x() + r(0, 1) * point.y() + r(0, 2) * point.z() + t.x();
    double const y = r(1, 0) * point.x() + r(1, 1) * point.y() + r(1, 2) * point.z() + t.y();
    double const z = r(2, 0) * point.x() + r(2, 1) * point.y() + r(2, 2) * point.z() + t.z();
    if (!(z >= nearest_m && z <= farthest_m))
        return {};
    double const u = truncated_code(camera.fx * x / z + camera.cx, bits.vertex_xy);
    double const v = truncated_code(camera.fy * y / z + camera.cy, bits.vertex_xy);
    double const depth = truncated_code(z, bits.vertex_z);
    if (!fits<std::int16_t>(u) || !fits<std::int16_t>(v) || !fits<std::uint16_t>(depth))
        return {};
    return {{static_cast<std::int16_t>(u), static_cast<std::int16_t>(v), static_cast<std::uint16_t>(depth)}, true};
}

void VertexTransformer::transform(std::size_t sample, std::vector<TriangleCode>& triangles) {
    vertices_.clear();
    for (Eigen::Vector3d const& point : posed_.mesh.vertices)
        vertices_.push_back(project(point, posed_.poses[sample], posed_.camera, bits_));
    triangles.assign(posed_.mesh.faces.size(), rejected());
    TriangleCode* triangle = triangles.data();
    for (auto const& face : posed_.mesh.faces) {
        ProjectedVertex const& a = vertices_[face[0]];
        ProjectedVertex const& b = vertices_[face[1]];
        ProjectedVertex const& c = vertices_[face[2]];
        if (a.usable && b.usable && c.usable)
            *triangle = {{a.code, b.code, c.code}};
        ++triangle;
    }
}

}  // namespace faster::datapath
