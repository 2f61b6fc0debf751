#include "faster/workload/sample_poses.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/object_pose.hpp"
#include "faster/workload/pose_list.hpp"
#include "support/temp_folder.hpp"

namespace sample_poses_test {

using namespace faster;
using namespace faster::workload;

SamplesConfig many(double translation_sigma_m, double rotation_sigma_deg) {
    SamplesConfig config;
    config.count = 20000;
    config.translation_sigma_m = translation_sigma_m;
    config.rotation_sigma_deg = rotation_sigma_deg;
    return config;
}

Pose some_truth() {
    SceneObjectConfig object;
    object.translation_m = {0.1, -0.2, 0.7};
    object.rotation_deg = {30, 40, 50};
    return configured_pose(object);
}

TEST_CASE("Random numbers are the same on every platform", "[random]") {
    std::mt19937_64 engine(5489);  // the standard gives the 10000th output of this seed
    engine.discard(9999);
    CHECK(engine() == 9981545732273789042U);
    Random random(1);
    CHECK(random.uniform() == 0x1p-53 * static_cast<double>(2469588189546311528U >> 11));  // its first output
}

TEST_CASE("Uniform numbers fill 0 to 1 without 1, normal numbers have mean 0 and deviation 1", "[random]") {
    Random random(3);
    double const draws = 100000;
    double uniform_sum = 0, sum = 0, sum_of_squares = 0, inside_one_sigma = 0;
    for (int draw = 0; draw < draws; ++draw) {
        double const uniform = random.uniform();
        REQUIRE(uniform >= 0);
        REQUIRE(uniform < 1);
        uniform_sum += uniform;
        double const normal = random.normal();
        REQUIRE(std::isfinite(normal));
        sum += normal;
        sum_of_squares += normal * normal;
        inside_one_sigma += std::abs(normal) < 1 ? 1 : 0;
    }
    CHECK(uniform_sum / draws == Approx(0.5).margin(0.005));
    CHECK(sum / draws == Approx(0).margin(0.02));
    CHECK(sum_of_squares / draws == Approx(1).margin(0.02));
    CHECK(inside_one_sigma / draws == Approx(0.6827).margin(0.01));
}

TEST_CASE("A configured pose turns about x, then y, then z of the camera", "[object_pose]") {
    SceneObjectConfig object;
    object.translation_m = {1, 2, 3};
    object.rotation_deg = {90, 0, 0};
    CHECK((configured_pose(object).rotation * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ()));
    object.rotation_deg = {90, 90, 90};  // y -> z -> x -> y
    CHECK((configured_pose(object).rotation * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitY()));
    CHECK(configured_pose(object).translation == Eigen::Vector3d(1, 2, 3));
}

TEST_CASE("The same seed gives the same poses, another seed others", "[sample_poses]") {
    SamplesConfig config;
    auto const poses = sample_poses(some_truth(), config);
    auto const again = sample_poses(some_truth(), config);
    config.seed += 1;
    auto const others = sample_poses(some_truth(), config);
    REQUIRE(poses.size() == config.count);
    CHECK(poses[7].translation == again[7].translation);
    CHECK(poses[7].rotation == again[7].rotation);
    CHECK(poses[7].translation != others[7].translation);
}

TEST_CASE("A sample does not depend on how many are drawn", "[sample_poses]") {
    SamplesConfig config;
    auto const many_poses = sample_poses(some_truth(), config);
    config.count = 3;
    auto const few_poses = sample_poses(some_truth(), config);
    REQUIRE(few_poses.size() == 3);
    CHECK(few_poses[2].translation == many_poses[2].translation);
    CHECK(few_poses[2].rotation == many_poses[2].rotation);
}

TEST_CASE("Without spread every sample is the true pose, without count there is none", "[sample_poses]") {
    SamplesConfig config;
    config.translation_sigma_m = 0;
    config.rotation_sigma_deg = 0;
    for (Pose const& pose : sample_poses(some_truth(), config)) {
        REQUIRE(pose.translation == some_truth().translation);
        REQUIRE(pose.rotation.isApprox(some_truth().rotation, 1e-12));
    }
    config.count = 0;
    CHECK(sample_poses(some_truth(), config).empty());
}

TEST_CASE("Samples spread as configured around the true pose", "[sample_poses]") {
    Pose const truth = some_truth();
    auto const config = many(0.01, 5);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), variance = Eigen::Vector3d::Zero(), axes = Eigen::Vector3d::Zero();
    double angle_variance = 0;
    for (Pose const& pose : sample_poses(truth, config)) {
        Eigen::Vector3d const shift = pose.translation - truth.translation;
        mean += shift / 20000;
        variance += shift.cwiseProduct(shift) / 20000;
        Eigen::AngleAxisd const turn(Eigen::Matrix3d(pose.rotation * truth.rotation.transpose()));
        angle_variance += turn.angle() * turn.angle() / 20000;
        axes += turn.axis().cwiseAbs2() / 20000;
        REQUIRE((pose.rotation * pose.rotation.transpose()).isIdentity(1e-12));
        REQUIRE(pose.rotation.determinant() == Approx(1));
    }
    CHECK(mean.norm() < 0.0005);
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::sqrt(variance[axis]) == Approx(0.01).epsilon(0.03));
        CHECK(axes[axis] == Approx(1.0 / 3).epsilon(0.03));  // no direction is preferred
    }
    CHECK(std::sqrt(angle_variance) / radians_per_degree == Approx(5).epsilon(0.03));
}

TEST_CASE("A table of poses brings back every bit", "[sample_poses]") {
    std::vector<Pose> const poses = sample_poses(some_truth(), many(0.01, 5));
    faster::test::TempFolder const folder;
    folder.write("poses.csv", pose_list_csv(poses));
    std::vector<Pose> const read = read_pose_list(folder / "poses.csv");
    REQUIRE(read.size() == poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        REQUIRE(read[i].rotation == poses[i].rotation);
        REQUIRE(read[i].translation == poses[i].translation);
    }
}

}  // namespace sample_poses_test
