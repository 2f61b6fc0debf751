#include "faster/reference/vertex_transform.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace faster::reference {
namespace {

constexpr double nearest_m = 0.1;
constexpr double farthest_m = 3.99;

constexpr VertexCode rejected_vertex{rejected_vertex_code, rejected_vertex_code, 0};
constexpr TriangleCode rejected_triangle{{rejected_vertex, rejected_vertex, rejected_vertex}};

// Row by row and left to right: the order decides the last bit, and Eigen's product promises none.
double camera_coordinate(Pose const& pose, Eigen::Index row, Eigen::Vector3d const& point) {
    return pose.rotation(row, 0) * point.x() + pose.rotation(row, 1) * point.y() + pose.rotation(row, 2) * point.z() +
           pose.translation(row);
}

// False for NaN too.
bool within(double value, double lowest, double highest) { return value >= lowest && value <= highest; }

bool fits_s16(double code) { return within(code, -32768.0, 32767.0); }
bool fits_u16(double code) { return within(code, 0.0, 65535.0); }

}  // namespace

VertexTransform::VertexTransform(Mesh const& mesh, Camera const& camera, FractionBits const& fraction)
    : mesh_(mesh),
      camera_(camera),
      xy_codes_per_px_(std::ldexp(1.0, fraction.vertex_xy)),
      z_codes_per_m_(std::ldexp(1.0, fraction.vertex_z)) {
    vertices_.reserve(mesh.vertices.size());
    triangles_.reserve(mesh.faces.size());
}

std::vector<TriangleCode> const& VertexTransform::operator()(Pose const& pose) {
    vertices_.clear();
    for (Eigen::Vector3d const& vertex : mesh_.vertices) {
        vertices_.push_back(project(pose, vertex));
    }
    triangles_.clear();
    for (auto const& face : mesh_.faces) {
        ImageVertex const& a = vertices_[face[0]];
        ImageVertex const& b = vertices_[face[1]];
        ImageVertex const& c = vertices_[face[2]];
        bool const accepted = a.accepted && b.accepted && c.accepted;
        triangles_.push_back(accepted ? TriangleCode{{a.code, b.code, c.code}} : rejected_triangle);
    }
    return triangles_;
}

VertexTransform::ImageVertex VertexTransform::project(Pose const& pose, Eigen::Vector3d const& vertex) const {
    double const x = camera_coordinate(pose, 0, vertex);
    double const y = camera_coordinate(pose, 1, vertex);
    double const z = camera_coordinate(pose, 2, vertex);
    if (!within(z, nearest_m, farthest_m)) {
        return {};
    }
    double const u = camera_.fx * x / z + camera_.cx;
    double const v = camera_.fy * y / z + camera_.cy;
    double const x_code = std::floor(u * xy_codes_per_px_);
    double const y_code = std::floor(v * xy_codes_per_px_);
    double const z_code = std::floor(z * z_codes_per_m_);
    // z fits by itself with up to 14 fractional bits; with more, a far vertex has no code.
    if (!fits_s16(x_code) || !fits_s16(y_code) || !fits_u16(z_code)) {
        return {};
    }
    return {{static_cast<std::int16_t>(x_code), static_cast<std::int16_t>(y_code), static_cast<std::uint16_t>(z_code)},
            true};
}

}  // namespace faster::reference
