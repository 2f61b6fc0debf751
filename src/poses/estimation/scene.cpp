#include "poses/estimation/scene.hpp"

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

double common_area(DetectionConfig const& a, DetectionConfig const& b) {
    double const width = std::min(a.left + a.width, b.left + b.width) - std::max(a.left, b.left);
    double const height = std::min(a.top + a.height, b.top + b.height) - std::max(a.top, b.top);
    return std::max(0.0, width) * std::max(0.0, height);
}

}  // namespace

Pose Scene::own(Pose pose) const {
    pose.translation += rotated(pose.rotation, own_origin);
    return pose;
}

Pose Scene::centred(Pose pose) const {
    pose.translation -= rotated(pose.rotation, own_origin);
    return pose;
}

void centre_mesh(Scene& scene) {
    Mesh& mesh = scene.observed.posed.mesh;
    scene.own_origin = -size_of(mesh).middle;
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += scene.own_origin;
    scene.size = size_of(mesh);
}

DetectionConfig box_around(std::vector<Eigen::Vector3d> const& points, Pose const& pose, Camera const& camera) {
    double left = camera.width, top = camera.height, right = 0, bottom = 0;
    for (Eigen::Vector3d const& point : points) {
        Eigen::Vector3d const p = rotated(pose.rotation, point) + pose.translation;
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

DetectionConfig visible_box(SampleCounters const& counters, SampleInput const& sample, int window) {
    if (counters.visible_top == 0)
        return {};
    DetectionConfig box;
    int const half = window / 2;
    box.left = sample.centre_col - half + static_cast<double>(counters.visible_left);
    box.top = sample.centre_row - half + static_cast<double>(counters.visible_top);
    box.width = static_cast<double>(counters.visible_right - counters.visible_left) + 1;
    box.height = static_cast<double>(counters.visible_bottom - counters.visible_top) + 1;
    return box;
}

double overlap_share(DetectionConfig const& a, DetectionConfig const& b) {
    double const common = common_area(a, b);
    double const together = a.width * a.height + b.width * b.height - common;
    return together > 0 ? common / together : 0;
}

double share_inside(DetectionConfig const& a, DetectionConfig const& b) {
    double const area = a.width * a.height;
    return area > 0 ? common_area(a, b) / area : 0;
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
