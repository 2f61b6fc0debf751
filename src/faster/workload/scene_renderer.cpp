#include "faster/workload/scene_renderer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "dataflow/base/held_signals.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::workload {
namespace {

using Eigen::Vector3d;

/// Corners nearer than this are not projected: their triangle may cover any pixel.
constexpr double nearest_projected_m = 1e-3;

/// Direction of the ray through a pixel, scaled to z = 1, so that a point on it is its depth times the direction.
Vector3d ray(Camera const& camera, int row, int column) {
    return {(column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0};
}

void keep_nearest(double& pixel, double depth_m) {
    if (pixel == 0 || depth_m < pixel) {
        pixel = depth_m;
    }
}

/// Pixels a triangle may cover, both ends included.
struct PixelBox {
    int first_row = 0, last_row = 0, first_column = 0, last_column = 0;
};

int clamped(double pixel, int size) { return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(size))); }

PixelBox pixel_box(Vector3d const (&corners)[3], Camera const& camera) {
    PixelBox box{0, camera.height - 1, 0, camera.width - 1};
    for (auto const& corner : corners) {
        if (corner.z() < nearest_projected_m) {
            return box;
        }
    }
    auto const u = [&](Vector3d const& p) { return camera.fx * p.x() / p.z() + camera.cx; };
    auto const v = [&](Vector3d const& p) { return camera.fy * p.y() / p.z() + camera.cy; };
    auto const [left, right] = std::minmax({u(corners[0]), u(corners[1]), u(corners[2])});
    auto const [top, bottom] = std::minmax({v(corners[0]), v(corners[1]), v(corners[2])});
    box.first_row = std::max(0, clamped(std::floor(top), camera.height));
    box.last_row = std::min(camera.height - 1, clamped(std::ceil(bottom), camera.height));
    box.first_column = std::max(0, clamped(std::floor(left), camera.width));
    box.last_column = std::min(camera.width - 1, clamped(std::ceil(right), camera.width));
    return box;
}

/// A ray d meets the triangle at depth z where z * d = b0*v0 + b1*v1 + b2*v2 with weights b >= 0 that sum to 1. Dotting
/// with the side planes v1 x v2, v2 x v0, v0 x v1 isolates the weights: z * d.(v1 x v2) = b0 * det, and so on.
void draw_triangle(Vector3d const (&corners)[3], Camera const& camera, DepthImage& depth) {
    Eigen::Matrix3d sides;
    sides.row(0) = corners[1].cross(corners[2]);
    sides.row(1) = corners[2].cross(corners[0]);
    sides.row(2) = corners[0].cross(corners[1]);
    double const signed_volume = corners[0].dot(sides.row(0));
    if (signed_volume < 0) {  // seen from behind
        sides = -sides;
    }
    double const volume = std::abs(signed_volume);
    PixelBox const box = pixel_box(corners, camera);
    for (int row = box.first_row; row <= box.last_row; ++row) {
        for (int column = box.first_column; column <= box.last_column; ++column) {
            Vector3d const weights = sides * ray(camera, row, column);
            double const sum = weights.sum();
            if (weights.minCoeff() >= 0 && sum > 0 && volume > 0) {
                keep_nearest(depth.at(row, column), volume / sum);
            }
        }
    }
}

}  // namespace

void draw_mesh(Mesh const& mesh, Pose const& pose, Camera const& camera, DepthImage& depth) {
    std::vector<Vector3d> in_camera;
    in_camera.reserve(mesh.vertices.size());
    for (auto const& vertex : mesh.vertices) {
        in_camera.emplace_back(pose.rotation * vertex + pose.translation);
    }
    for (auto const& face : mesh.faces) {
        processes::give_up_if_interrupted();  // a mesh in millimetres covers every pixel with each of its faces
        draw_triangle({in_camera[face[0]], in_camera[face[1]], in_camera[face[2]]}, camera, depth);
    }
}

void draw_plane(Plane const& plane, Camera const& camera, DepthImage& depth) {
    double const distance = plane.normal.dot(plane.point);
    for (int row = 0; row < depth.height(); ++row) {
        for (int column = 0; column < depth.width(); ++column) {
            double const depth_m = distance / plane.normal.dot(ray(camera, row, column));
            if (depth_m > 0 && std::isfinite(depth_m)) {
                keep_nearest(depth.at(row, column), depth_m);
            }
        }
    }
}

}  // namespace faster::workload
