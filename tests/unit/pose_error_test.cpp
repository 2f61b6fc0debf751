#include "poses/judging/pose_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "dataflow/base/random.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/judging/model_symmetries.hpp"
#include "support/bop_folder.hpp"

namespace pose_error_test {

using namespace faster;
using namespace faster::poses;
using Eigen::Vector3d;
using faster::Random;
using faster::test::BopFolder;

Pose at(Vector3d const& translation) { return {Eigen::Matrix3d::Identity(), translation}; }

Pose turned(double angle, Vector3d const& axis = Vector3d::UnitZ()) {
    return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), Vector3d::Zero()};
}

Pose random_pose(Random& random) {
    Pose pose = turned(6 * random.uniform(), {random.normal(), random.normal(), random.normal()});
    pose.translation = {random.normal(), random.normal(), random.normal()};
    return pose;
}

Points random_points(Random& random, std::size_t count) {
    Points points;
    while (points.size() < count)
        points.emplace_back(random.normal(), random.normal(), random.normal());
    return points;
}

bop::ObjectModel cylinder_about(Vector3d const& offset) {
    bop::ObjectModel model;
    model.axes.push_back({Vector3d::UnitZ(), offset});
    return model;
}

TEST_CASE("ADD of a shift is its length, ADD of a half turn the mean diameter of the points' circles", "[pose_error]") {
    Points const points{{0.1, 0, 0}, {-0.1, 0, 0.3}, {0, 0.2, 0}};
    CHECK(add(points, at({0.03, 0.04, 0}), Pose{}) == Approx(0.05));
    CHECK(add(points, turned(portable::pi), Pose{}) == Approx((0.2 + 0.2 + 0.4) / 3));
}

TEST_CASE("ADD-S goes from the true points to the nearest estimated ones, and not back", "[pose_error]") {
    Points const points{{0, 0, 0}, {1, 0, 0}, {10, 0, 0}};
    // Estimated at 9, 10, 19: from 0 it is 9, from 1 it is 8, from 10 none. The other way it would be 1, 0 and 9.
    CHECK(add_s(points, at({9, 0, 0}), Pose{}) == Approx(17.0 / 3));
    CHECK(std::isinf(add_s(points, at({1e300, 0, 0}), Pose{})));  // as add() is
    CHECK(std::isinf(add(points, at({1e300, 0, 0}), Pose{})));
    CHECK(add_s(points, Pose{}, at({9, 0, 0})) == Approx(10.0 / 3));
}

TEST_CASE("ADD-S forgives what nobody can see: points that change places", "[pose_error]") {
    Points const points{{0.1, 0, 0}, {-0.1, 0, 0}};
    CHECK(add(points, turned(portable::pi), Pose{}) == Approx(0.2));
    CHECK(add_s(points, turned(portable::pi), Pose{}) == Approx(0).margin(1e-15));
}

TEST_CASE("The nearest points are those that a search through all of them finds", "[pose_error]") {
    auto const seed = static_cast<std::uint64_t>(GENERATE(range(1, 6)));
    CAPTURE(seed);
    Random random(seed);
    Points const from = random_points(random, 150), to = random_points(random, 97);
    double sum = 0;
    for (Vector3d const& point : from) {
        double least = 1e9;
        for (Vector3d const& other : to)
            least = std::min(least, (point - other).norm());
        sum += least;
    }
    CHECK(mean_nearest_distance(from, to) == Approx(sum / 150).epsilon(1e-12));
}

TEST_CASE("Errors do not depend on where camera and world are", "[pose_error]") {
    Random random(7);
    Points const points = random_points(random, 60);
    Pose const estimate = random_pose(random), truth = random_pose(random), camera = random_pose(random);
    auto const seen = [&](Pose const& pose) {
        return Pose{camera.rotation * pose.rotation, camera.rotation * pose.translation + camera.translation};
    };
    CHECK(add(points, seen(estimate), seen(truth)) == Approx(add(points, estimate, truth)));
    CHECK(add_s(points, seen(estimate), seen(truth)) == Approx(add_s(points, estimate, truth)));
    CHECK(mssd(points, {Pose{}}, seen(estimate), seen(truth)) == Approx(mssd(points, {Pose{}}, estimate, truth)));
}

TEST_CASE("MSSD is the distance of the worst point, for the symmetry with which it is least", "[pose_error]") {
    Points const points = BopFolder::mesh_of(BopFolder::box).vertices;  // 60 x 40 x 100 mm
    bop::ObjectModel plain, half_turn;
    half_turn.symmetries.push_back(turned(portable::pi));
    double const radius = std::hypot(0.03, 0.02);
    auto const error = [&](bop::ObjectModel const& model, double angle) {
        return mssd(points, symmetries_of(model), turned(angle), Pose{});
    };
    CHECK(error(plain, portable::pi) == Approx(2 * radius));
    CHECK(error(half_turn, portable::pi) == Approx(0).margin(1e-15));
    CHECK(error(half_turn, portable::pi / 2) == Approx(2 * radius * std::sin(portable::pi / 4)));
    CHECK(error(half_turn, portable::pi - 0.2) == Approx(2 * radius * std::sin(0.1)));
}

TEST_CASE("A symmetry is applied to the model, not to the camera", "[pose_error]") {
    Points const points = BopFolder::mesh_of(BopFolder::box).vertices;
    bop::ObjectModel model;
    model.symmetries.push_back(turned(portable::pi));
    Pose const truth = BopFolder::pose_of(BopFolder::box, 3);
    Pose estimate = truth;
    estimate.rotation = truth.rotation * turned(portable::pi).rotation;
    CHECK(mssd(points, symmetries_of(model), estimate, truth) == Approx(0).margin(1e-12));
    estimate.rotation = turned(portable::pi).rotation * truth.rotation;
    CHECK(mssd(points, symmetries_of(model), estimate, truth) > 0.01);
}

TEST_CASE("A cylinder that is turned about its axis has an MSSD of half a step at most", "[pose_error]") {
    Points const points = BopFolder::mesh_of(BopFolder::cylinder).vertices;
    double const half_step = portable::pi / 315, radius = 0.025;
    auto const symmetries = symmetries_of(cylinder_about(Vector3d::Zero()));
    for (double const angle : {0.0, 0.3, 1.0, 2.5, 4.4, 6.2}) {
        CAPTURE(angle);
        CHECK(mssd(points, symmetries, turned(angle), Pose{}) <= 2 * radius * std::sin(half_step / 2) + 1e-12);
    }
    CHECK(mssd(points, symmetries, turned(7 * half_step), Pose{}) ==
          Approx(2 * radius * std::sin(half_step / 2)));  // in the middle of two steps
    CHECK(mssd(points, symmetries, turned(0.3, Vector3d::UnitX()), Pose{}) > 0.01);
}

TEST_CASE("There are 315 turns about an axis, after each discrete symmetry, and none moves the axis", "[pose_error]") {
    Vector3d const offset(0.01, -0.02, 0.3);
    bop::ObjectModel model = cylinder_about(offset);
    CHECK(symmetries_of(model).size() == 315);
    for (Pose const& symmetry : symmetries_of(model))
        CHECK((symmetry.rotation * offset + symmetry.translation - offset).norm() < 1e-15);
    model.symmetries.push_back(turned(portable::pi, Vector3d::UnitX()));
    CHECK(symmetries_of(model).size() == 630);
    CHECK(symmetries_of(bop::ObjectModel{}).size() == 1);
}

TEST_CASE("The diameter is the largest distance of two points", "[pose_error]") {
    CHECK(diameter_of(BopFolder::mesh_of(BopFolder::box).vertices) ==
          Approx(std::sqrt(0.06 * 0.06 + 0.04 * 0.04 + 0.01)));
}

}  // namespace pose_error_test
