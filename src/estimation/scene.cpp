#include "estimation/scene.hpp"

#include <algorithm>
#include <cmath>

namespace faster::estimation {

namespace {

constexpr double nearest_vertex_m = 0.1;

/// Whole pixels [first, end) of a stretch of the image.
struct Pixels {
    Pixels(double begin, double length, int size)
        : first(static_cast<int>(std::clamp(std::floor(begin), 0.0, 1.0 * size))),
          end(static_cast<int>(std::clamp(std::ceil(begin + length), 1.0 * first, 1.0 * size))) {}
    int first;
    int end;
};

}  // namespace

DetectionConfig box_around(Mesh const& mesh, Pose const& pose, Camera const& camera) {
    double left = camera.width, top = camera.height, right = 0, bottom = 0;
    for (Eigen::Vector3d const& vertex : mesh.vertices) {
        Eigen::Vector3d const p = rotated(pose.rotation, vertex) + pose.translation;
        if (p.z() < nearest_vertex_m)
            return {};
        double const u = camera.fx * p.x() / p.z() + camera.cx, v = camera.fy * p.y() / p.z() + camera.cy;
        left = std::min(left, u);
        right = std::max(right, u);
        top = std::min(top, v);
        bottom = std::max(bottom, v);
    }
    DetectionConfig box;
    box.left = std::max(0.0, left);
    box.top = std::max(0.0, top);
    box.width = std::max(0.0, std::min<double>(right, camera.width - 1) - box.left);
    box.height = std::max(0.0, std::min<double>(bottom, camera.height - 1) - box.top);
    return box;
}

bool overlaps(DetectionConfig const& box, int width, int height) {
    return box.left < width && box.top < height && box.left + box.width > 0 && box.top + box.height > 0;
}

bool contains(DetectionConfig const& box, Eigen::Vector3d const& point, Camera const& camera) {
    if (point.z() <= 0)
        return false;
    double const col = camera.fx * point.x() / point.z() + camera.cx;
    double const row = camera.fy * point.y() / point.z() + camera.cy;
    return col >= box.left && col < box.left + box.width && row >= box.top && row < box.top + box.height;
}

std::size_t readings_in(DetectionConfig const& box, Image<std::uint16_t> const& depth) {
    Pixels const rows(box.top, box.height, depth.height()), cols(box.left, box.width, depth.width());
    std::size_t readings = 0;
    for (int row = rows.first; row < rows.end; ++row)
        for (int col = cols.first; col < cols.end; ++col)
            readings += depth.at(row, col) != 0 ? 1U : 0U;
    return readings;
}

}  // namespace faster::estimation
