#include "modules/core/workload_iterations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace faster {

namespace {

constexpr double passes_over_window = 4;    ///< clear, build, sweep, read observations
constexpr double iterations_of_corner = 4;  ///< of transform and setup, for each corner of a triangle
constexpr std::size_t most_looked_at = 10'000;

/// Pixels of a box, no larger than the window.
class Box {
  public:
    explicit Box(double window) : window_(window) {}

    void add(double column, double row) {
        left_ = std::min(left_, column);
        right_ = std::max(right_, column);
        top_ = std::min(top_, row);
        bottom_ = std::max(bottom_, row);
    }
    double pixels() const { return side(right_ - left_) * side(bottom_ - top_); }

  private:
    double side(double length) const { return std::isfinite(length) ? std::min(length + 1, window_) : window_; }

    static constexpr double far = std::numeric_limits<double>::infinity();

    double window_;
    double left_ = far, right_ = -far, top_ = far, bottom_ = -far;
};

double pixels_of(TriangleCode const& triangle, double pixels_per_code, double window) {
    Box box(window);
    for (VertexCode const& vertex : triangle.vertex)
        box.add(vertex.x * pixels_per_code, vertex.y * pixels_per_code);
    return box.pixels();
}

double pixels_of(std::array<std::uint32_t, 3> const& face, PosedMesh const& posed, double window) {
    Box box(window);
    for (std::uint32_t const vertex : face) {
        Eigen::Vector3d const point =
            posed.poses.front().rotation * posed.mesh.vertices[vertex] + posed.poses.front().translation;
        box.add(posed.camera.fx * point.x() / point.z(), posed.camera.fy * point.y() / point.z());
    }
    return box.pixels();
}

/// The mean of what `pixels` says of some of so many triangles.
template <class Pixels> double mean_pixels(std::size_t triangles, Pixels pixels) {
    if (triangles == 0)
        return 0;
    std::size_t const step = 1 + triangles / most_looked_at;
    double sum = 0;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < triangles; i += step, ++seen)
        sum += pixels(i);
    return sum / static_cast<double>(seen);
}

LoopIterations iterations_of(double samples, double window, double triangles, double pixels_of_triangle) {
    return {samples * passes_over_window * window * window,
            triangles * (3 * iterations_of_corner + pixels_of_triangle)};
}

}  // namespace

LoopIterations loop_iterations(Stimulus const& observed, std::size_t samples) {
    constexpr double boxes_over_pixel = 4;  // front and back, and a box is twice its triangle
    auto const window = static_cast<double>(observed.window);
    auto const faces = static_cast<double>(observed.posed.mesh.faces.size());
    double const pixels = faces > 0 ? std::min(boxes_over_pixel / faces, 1.0) * window * window : 0;
    return iterations_of(static_cast<double>(samples), window, static_cast<double>(samples) * faces, pixels);
}

LoopIterations loop_iterations(Stimulus const& stimulus) {
    auto const samples = static_cast<double>(stimulus.samples.size());
    auto const window = static_cast<double>(stimulus.window);
    double triangles = 0, pixels = 0;
    if (stimulus.is_posed()) {
        PosedMesh const& posed = stimulus.posed;
        triangles = samples * static_cast<double>(posed.mesh.faces.size());
        pixels = mean_pixels(posed.mesh.faces.size(),
                             [&](std::size_t i) { return pixels_of(posed.mesh.faces[i], posed, window); });
    } else {
        for (SampleInput const& sample : stimulus.samples)
            triangles += sample.triangle_count;
        double const pixels_per_code = std::ldexp(1.0, -stimulus.fraction.vertex_xy);
        pixels = mean_pixels(stimulus.triangles.size(),
                             [&](std::size_t i) { return pixels_of(stimulus.triangles[i], pixels_per_code, window); });
    }
    return iterations_of(samples, window, triangles, pixels);
}

}  // namespace faster
