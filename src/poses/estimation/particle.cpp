#include "poses/estimation/particle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dataflow/base/portable_math.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::estimation {

namespace {

/// Uniform in the unit disc without its centre, and how far from that.
struct DiscPoint {
    double x, y, square;
};
DiscPoint disc_point(CounterRandom& random) {
    while (true) {
        double const x = 2 * random.uniform() - 1;
        double const y = 2 * random.uniform() - 1;
        double const square = x * x + y * y;
        if (square > 0 && square < 1)
            return {x, y, square};
    }
}

Eigen::Vector3d direction(CounterRandom& random) {
    DiscPoint const point = disc_point(random);
    double const scale = 2 * std::sqrt(1 - point.square);
    return {point.x * scale, point.y * scale, 1 - 2 * point.square};
}

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

Eigen::Matrix3d Rotation::matrix() const {
    Eigen::Matrix3d m;
    m(0, 0) = 1 - 2 * (y * y + z * z);
    m(0, 1) = 2 * (x * y - w * z);
    m(0, 2) = 2 * (x * z + w * y);
    m(1, 0) = 2 * (x * y + w * z);
    m(1, 1) = 1 - 2 * (x * x + z * z);
    m(1, 2) = 2 * (y * z - w * x);
    m(2, 0) = 2 * (x * z - w * y);
    m(2, 1) = 2 * (y * z + w * x);
    m(2, 2) = 1 - 2 * (x * x + y * y);
    return m;
}

Rotation product(Rotation const& a, Rotation const& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Rotation normalized(Rotation const& rotation) {
    double const length = std::sqrt(dot(rotation, rotation));
    return {rotation.w / length, rotation.x / length, rotation.y / length, rotation.z / length};
}

double dot(Rotation const& a, Rotation const& b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }

double angle_between(Rotation const& a, Rotation const& b) {
    double const cosine = std::min(1.0, std::abs(dot(a, b)));
    return 2 * portable::angle_of(std::sqrt(1 - cosine * cosine), cosine);
}

/// By the largest of the four components, whose root loses no digits.
Rotation rotation_of(Eigen::Matrix3d const& m) {
    double const squares[4]{1 + m(0, 0) + m(1, 1) + m(2, 2), 1 + m(0, 0) - m(1, 1) - m(2, 2),
                            1 - m(0, 0) + m(1, 1) - m(2, 2), 1 - m(0, 0) - m(1, 1) + m(2, 2)};
    auto const largest = std::max_element(squares, squares + 4) - squares;
    double const xy = m(1, 0) + m(0, 1), xz = m(0, 2) + m(2, 0), yz = m(2, 1) + m(1, 2);
    double const wx = m(2, 1) - m(1, 2), wy = m(0, 2) - m(2, 0), wz = m(1, 0) - m(0, 1);
    Rotation const columns[4]{
        {squares[0], wx, wy, wz}, {wx, squares[1], xy, xz}, {wy, xy, squares[2], yz}, {wz, xz, yz, squares[3]}};
    return normalized(columns[largest]);
}

Eigen::Vector3d rotated(Eigen::Matrix3d const& r, Eigen::Vector3d const& v) {
    auto const row = [&](Eigen::Index i) { return r(i, 0) * v.x() + r(i, 1) * v.y() + r(i, 2) * v.z(); };
    return {row(0), row(1), row(2)};
}

Rotation uniform_rotation(CounterRandom& random) {
    DiscPoint const a = disc_point(random);
    DiscPoint const b = disc_point(random);
    double const scale = std::sqrt((1 - a.square) / b.square);
    return {a.x, a.y, b.x * scale, b.y * scale};
}

Rotation random_turn(CounterRandom& random, double sigma) {
    Eigen::Vector3d const axis = direction(random);
    auto const [sine, cosine] = portable::sine_and_cosine(sigma * random.normal() / 2);
    return {cosine, sine * axis.x(), sine * axis.y(), sine * axis.z()};
}

ObjectSize size_of(Mesh const& mesh) {
    ObjectSize size;
    if (mesh.vertices.empty())
        return size;
    Eigen::AlignedBox3d const box = box_of(mesh);
    size.middle = box.center();
    size.least_extent = box.sizes().minCoeff();
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
