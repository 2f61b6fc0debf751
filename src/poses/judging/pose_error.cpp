#include "poses/judging/pose_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "poses/grip/point_tree.hpp"

namespace faster::poses {

namespace {

double nearest_distance(grip::PointTree const& tree, Eigen::Vector3d const& point) {
    double const square = tree.nearest(point).squared_distance;
    bool const is_beyond_doubles = square == std::numeric_limits<double>::max();
    return is_beyond_doubles ? std::numeric_limits<double>::infinity() : std::sqrt(square);
}

Points moved(Points const& points, Pose const& pose) {
    Points result;
    result.reserve(points.size());
    for (Eigen::Vector3d const& point : points)
        result.emplace_back(pose.rotation * point + pose.translation);
    return result;
}

/// First `inner`, then `outer`.
Pose chained(Pose const& outer, Pose const& inner) {
    return {outer.rotation * inner.rotation, outer.rotation * inner.translation + outer.translation};
}

/// The square of the largest distance between `places` and the points moved to `pose`; only that it is no less than
/// `enough` once it has come to that.
double largest_squared_distance(Points const& places, Points const& points, Pose const& pose, double enough) {
    double largest = 0;
    for (std::size_t i = 0; i < points.size() && largest < enough; ++i)
        largest = std::max(largest, (places[i] - (pose.rotation * points[i] + pose.translation)).squaredNorm());
    return largest;
}

}  // namespace

double mean_nearest_distance(Points const& from, Points const& to) {
    grip::PointTree const tree(to);
    double sum = 0;
    for (Eigen::Vector3d const& point : from)
        sum += nearest_distance(tree, point);
    return sum / static_cast<double>(from.size());
}

double largest_nearest_distance(Points const& from, Points const& to) {
    grip::PointTree const tree(to);
    double largest = 0;
    for (Eigen::Vector3d const& point : from)
        largest = std::max(largest, nearest_distance(tree, point));
    return largest;
}

double add(Points const& points, Pose const& estimate, Pose const& truth) {
    double sum = 0;
    for (Eigen::Vector3d const& point : points)
        sum += (estimate.rotation * point + estimate.translation - (truth.rotation * point + truth.translation)).norm();
    return sum / static_cast<double>(points.size());
}

double add_s(Points const& points, Pose const& estimate, Pose const& truth) {
    return mean_nearest_distance(moved(points, truth), moved(points, estimate));
}

double mssd(Points const& points, std::vector<Pose> const& symmetries, Pose const& estimate, Pose const& truth) {
    Points const estimated = moved(points, estimate);
    double least = std::numeric_limits<double>::infinity();
    for (Pose const& symmetry : symmetries)
        least = std::min(least, largest_squared_distance(estimated, points, chained(truth, symmetry), least));
    return std::sqrt(least);
}

double mspd(Points const& points, std::vector<Pose> const& symmetries, Pose const& estimate, Pose const& truth,
            Camera const& camera) {
    auto const place = [&](Pose const& pose, Eigen::Vector3d const& point) {
        Eigen::Vector3d const p = pose.rotation * point + pose.translation;
        return Eigen::Vector2d(camera.fx * p.x() / p.z() + camera.cx, camera.fy * p.y() / p.z() + camera.cy);
    };
    std::vector<Eigen::Vector2d> estimated;
    for (Eigen::Vector3d const& point : points)
        estimated.push_back(place(estimate, point));
    double least = std::numeric_limits<double>::infinity();
    for (Pose const& symmetry : symmetries) {
        Pose const pose = chained(truth, symmetry);
        double largest = 0;
        for (std::size_t i = 0; i < points.size() && largest < least; ++i) {
            double const square = (estimated[i] - place(pose, points[i])).squaredNorm();
            largest = std::isfinite(square) ? std::max(largest, square) : least;
        }
        least = std::min(least, largest);
    }
    return std::sqrt(least);
}

}  // namespace faster::poses
