#include "poses/estimation/icp.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "poses/grip/point_tree.hpp"
#include "poses/grip/rendered_object.hpp"

namespace faster::estimation {

namespace {

constexpr int most_rounds = 30, margin_px = 20;
constexpr std::size_t least_pairs = 30, most_points = 2000;
constexpr double first_reach_m = 0.02, last_reach_m = 0.006, reach_decay = 0.85, close_m = 0.008;
constexpr double small_step_m = 2e-5, small_turn_rad = 2e-4;

using Readings = std::vector<Eigen::Vector3d>;

/// A point of the surface that the camera would see.
struct SurfacePoint {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;
};

Readings readings_around(grip::PointCloud const& cloud, grip::RenderedObject const& object) {
    Readings readings;
    int const bottom = std::min(cloud.height(), object.first_row + object.depth.height() + margin_px);
    int const right = std::min(cloud.width(), object.first_col + object.depth.width() + margin_px);
    for (int row = std::max(0, object.first_row - margin_px); row < bottom; ++row)
        for (int col = std::max(0, object.first_col - margin_px); col < right; ++col)
            if (grip::has_point(cloud.at(row, col)))
                readings.push_back(cloud.at(row, col));
    return readings;
}

/// Pixels whose right and lower neighbours are drawn as well, at most `most_points` of them, evenly over the image.
std::vector<SurfacePoint> surface_of(grip::RenderedObject const& object, Camera const& camera) {
    auto const point_at = [&](int row, int col) {
        return grip::back_projected(camera, row + object.first_row, col + object.first_col, object.depth.at(row, col));
    };
    std::size_t const pixels = object.depth.pixels().size();
    int const step = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pixels) / most_points))));
    std::vector<SurfacePoint> surface;
    for (int row = 0; row + 1 < object.depth.height(); row += step)
        for (int col = 0; col + 1 < object.depth.width(); col += step) {
            if (object.depth.at(row, col) == 0 || object.depth.at(row, col + 1) == 0 ||
                object.depth.at(row + 1, col) == 0)
                continue;
            Eigen::Vector3d const point = point_at(row, col);
            Eigen::Vector3d const across = point_at(row, col + 1) - point, down = point_at(row + 1, col) - point;
            surface.push_back({point, across.cross(down).normalized()});
        }
    return surface;
}

/// A small turn about the object's origin, and a shift.
struct Step {
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();

    bool is_small() const { return turn.norm() < small_turn_rad && shift.norm() < small_step_m; }
};

/// The surface at one pose, and the readings near it.
class Matching {
  public:
    Matching(Stimulus const& observed, grip::PointTree const& tree, Readings const& readings, Pose const& pose)
        : origin_(pose.translation) {
        Camera const& camera = observed.posed.camera;
        for (SurfacePoint const& of_surface : surface_of(grip::render(observed.posed.mesh, pose, camera), camera)) {
            grip::PointTree::Nearest const nearest = tree.nearest(of_surface.point);
            pairs_.push_back({of_surface, readings[nearest.index], std::sqrt(nearest.squared_distance)});
        }
    }

    /// Of the points of the surface.
    double close_share() const {
        auto const close =
            std::count_if(pairs_.begin(), pairs_.end(), [](Pair const& pair) { return pair.distance_m < close_m; });
        return pairs_.empty() ? 0 : static_cast<double>(close) / static_cast<double>(pairs_.size());
    }

    /// The least squares of the pairs within `reach_m`; no step if there are few.
    Step step(double reach_m) const {
        double const radius_m = radius();
        Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
        Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
        std::size_t used = 0;
        for (Pair const& pair : pairs_) {
            if (pair.distance_m >= reach_m)
                continue;
            double const share = pair.distance_m / reach_m, weight = (1 - share * share) * (1 - share * share);
            Eigen::Matrix<double, 6, 1> row;
            row << (pair.surface.point - origin_).cross(pair.surface.normal) / radius_m, pair.surface.normal;
            normal += weight * row * row.transpose();
            right += weight * row * pair.surface.normal.dot(pair.reading - pair.surface.point);
            ++used;
        }
        if (used < least_pairs)
            return {};
        Eigen::Matrix<double, 6, 1> const solution = solved(normal, right);
        return {solution.head<3>() / radius_m, solution.tail<3>()};
    }

  private:
    struct Pair {
        SurfacePoint surface;
        Eigen::Vector3d reading;
        double distance_m;
    };

    /// Root mean square of the points' distances from the origin [m]: by it turns are compared with shifts.
    double radius() const {
        double squares = 0;
        for (Pair const& pair : pairs_)
            squares += (pair.surface.point - origin_).squaredNorm();
        return pairs_.empty() ? 1 : std::sqrt(squares / static_cast<double>(pairs_.size()));
    }

    /// Along directions of which the pairs say next to nothing, as along a plane, there is no step.
    static Eigen::Matrix<double, 6, 1> solved(Eigen::Matrix<double, 6, 6> const& normal,
                                              Eigen::Matrix<double, 6, 1> const& right) {
        constexpr double least_share = 0.01;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> const directions(normal);
        Eigen::Matrix<double, 6, 1> solution = Eigen::Matrix<double, 6, 1>::Zero();
        for (Eigen::Index i = 0; i < 6; ++i) {
            double const value = directions.eigenvalues()(i);
            auto const direction = directions.eigenvectors().col(i);
            if (value > least_share * directions.eigenvalues()(5))
                solution += direction * (direction.dot(right) / value);
        }
        return solution;
    }

    Eigen::Vector3d origin_;
    std::vector<Pair> pairs_;
};

Pose moved(Pose pose, Step const& step) {
    double const angle = step.turn.norm();
    if (angle > 0)
        pose.rotation = Eigen::AngleAxisd(angle, step.turn / angle).toRotationMatrix() * pose.rotation;
    pose.translation += step.shift;
    return pose;
}

}  // namespace

Pose refined_by_icp(Stimulus const& observed, Pose const& start) {
    Readings const readings = readings_around(grip::observed_cloud(observed),
                                              grip::render(observed.posed.mesh, start, observed.posed.camera));
    if (readings.size() < least_pairs)
        return start;
    grip::PointTree const tree(readings);
    Pose pose = start;
    double reach_m = first_reach_m;
    for (int round = 0; round < most_rounds; ++round) {
        Step const step = Matching(observed, tree, readings, pose).step(reach_m);
        pose = moved(pose, step);
        if (step.is_small() && reach_m == last_reach_m)
            break;
        reach_m = std::max(last_reach_m, reach_m * reach_decay);
    }
    bool const is_better = Matching(observed, tree, readings, pose).close_share() >=
                           Matching(observed, tree, readings, start).close_share();
    return is_better ? pose : start;
}

}  // namespace faster::estimation
