#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "faster/data/fixed_point.hpp"
#include "poses/grip/rank_correlation.hpp"
#include "poses/grip/rendered_object.hpp"
#include "poses/grip/score_poses.hpp"

namespace faster::grip::grip_test {

Camera small_camera() {
    Camera camera;
    camera.width = 40;
    camera.height = 30;
    camera.fx = camera.fy = 50;
    camera.cx = 20;
    camera.cy = 15;
    return camera;
}

/// A square of side 0.4 m facing the camera, and a second one of half the side, `step` nearer.
Mesh plate(double step) {
    Mesh mesh;
    for (auto const& [half, z] : {std::pair{0.2, 0.0}, {0.1, -step}}) {
        auto const first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (auto const& [x, y] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {1, -1}})
            mesh.vertices.emplace_back(x * half, y * half, z);
        mesh.faces.push_back({first, first + 1, first + 2});
        mesh.faces.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

Pose at_distance(double z) {
    Pose pose;
    pose.translation = {0, 0, z};
    return pose;
}

/// The scene is the object itself under its first pose, as the sensor would see it.
Stimulus scene_of(Mesh const& mesh, std::vector<Pose> const& poses) {
    Stimulus stimulus;
    stimulus.posed = {mesh, small_camera(), poses};
    stimulus.width = stimulus.posed.camera.width;
    stimulus.height = stimulus.posed.camera.height;
    RenderedObject const seen = render(mesh, poses.at(0), stimulus.posed.camera);
    stimulus.observed_depth = Image<std::uint16_t>(stimulus.height, stimulus.width);
    for (int row = 0; row < seen.depth.height(); ++row)
        for (int col = 0; col < seen.depth.width(); ++col)
            stimulus.observed_depth.at(row + seen.first_row, col + seen.first_col) =
                static_cast<std::uint16_t>(seen.depth.at(row, col) * 512);
    return stimulus;
}

PointCloud cloud_of(std::vector<Eigen::Vector3d> const& points) {
    auto const side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(points.size()))));
    PointCloud cloud(side, side, Eigen::Vector3d::Zero());
    cloud.pixels() = points;
    return cloud;
}

TEST_CASE("Eq. 2.1: points agree if they are less than epsilon apart, in all three coordinates", "[grip]") {
    CHECK(is_inlier({0, 0, 1}, {0, 0, 1}, 0.008));
    CHECK(is_inlier({0, 0, 1}, {0.004, 0, 1.004}, 0.008));        // 5.7 mm
    CHECK_FALSE(is_inlier({0, 0, 1}, {0.006, 0, 1.006}, 0.008));  // 8.5 mm
    CHECK_FALSE(is_inlier({0, 0, 1}, {0, 0, 1.5}, 0.5));          // not less
}

TEST_CASE("Eq. 2.2: the curvature of a corner, by hand", "[grip]") {
    // A point at (0, 0, 2); two neighbours 0.1 beside it and 1 behind, six at its own place: the sum of differences is
    // (0.2, 0, 2), its length 2.00998; eight neighbours at distance 2 make 16.
    std::vector<Eigen::Vector3d> points(9, {0, 0, 2});
    points[2] = points[8] = Eigen::Vector3d(0.1, 0, 3);
    CHECK(curvature(cloud_of(points), 1, 1, 1) == Approx(std::sqrt(4.04) / 16));
    // Without point 2: (0.1, 0, 1) over seven neighbours.
    points[2] = Eigen::Vector3d::Zero();
    CHECK(curvature(cloud_of(points), 1, 1, 1) == Approx(std::sqrt(1.01) / 14));
    // In a corner of the image three neighbours are left, none of them elsewhere.
    CHECK(curvature(cloud_of(points), 0, 0, 1) == 0);
}

TEST_CASE("Eq. 2.2: a lone point has no curvature", "[grip]") { CHECK(curvature(cloud_of({{0, 0, 1}}), 0, 0, 1) == 0); }

TEST_CASE("Eq. 2.3: ratios of raw, edge and planar points, by hand", "[grip]") {
    // Four rendered points: an edge that is one, an edge that is observed as planar, a planar one 1 cm off, and one
    // where nothing is observed.
    Eigen::Vector3d const point(0, 0, 1);
    PoseScore score;
    score.count(Feature::edge, point, Feature::edge, {0, 0, 1}, 0.008, true);
    score.count(Feature::edge, point, Feature::planar, {0, 0, 1}, 0.008, true);
    score.count(Feature::planar, point, Feature::planar, {0, 0, 1.01}, 0.008, true);
    score.count(Feature::planar, point, Feature::none, {0, 0, 0}, 0.008, false);
    CHECK(score.raw.ratio() == 0.5);
    CHECK(score.edge.ratio() == 0.5);
    CHECK(score.planar.points == 2);
    CHECK(score.planar.ratio() == 0);
    CHECK(score.in_box.points == 3);
    CHECK(score.in_box.inliers == 2);
    CHECK(score.weight() == Approx(1.0 / 3));
    CHECK(InlierCount{}.ratio() == 0);
}

TEST_CASE("Of the surfaces at a pixel the nearest counts, where its centre is covered", "[grip]") {
    Camera const camera = small_camera();
    RenderedObject const object = render(plate(0.1), at_distance(1), camera);
    for (int row = 0; row < camera.height; ++row)
        for (int col = 0; col < camera.width; ++col) {
            CAPTURE(row, col);
            // 0.4 m at 1 m: 20 px around the centre; 0.2 m at 0.9 m: 11.1 px
            bool const far = std::abs(col - 20) <= 10 && std::abs(row - 15) <= 10;
            bool const near = std::abs(col - 20) <= 5 && std::abs(row - 15) <= 5;
            int const r = row - object.first_row, c = col - object.first_col;
            double const z = object.depth.contains(r, c) ? object.depth.at(r, c) : 0;
            CHECK(z == Approx(near ? 0.9 : far ? 1.0 : 0.0));
        }
    CHECK(render(plate(0.1), at_distance(-1), camera).depth.empty());
}

/// The whole image as a cloud, the object before a plane at depth `z`, for the formula as it stands.
PointCloud cloud_of(RenderedObject const& object, Camera const& camera, double z) {
    PointCloud cloud(camera.height, camera.width);
    for (int row = 0; row < camera.height; ++row)
        for (int col = 0; col < camera.width; ++col)
            cloud.at(row, col) = back_projected(camera, row, col, z);
    for (int row = 0; row < object.depth.height(); ++row)
        for (int col = 0; col < object.depth.width(); ++col)
            if (double const at = object.depth.at(row, col); at > 0)
                cloud.at(row + object.first_row, col + object.first_col) =
                    back_projected(camera, row + object.first_row, col + object.first_col, at);
    return cloud;
}

TEST_CASE("Features by sliding sums are those of eq. 2.2 point by point, at the image's border too", "[grip]") {
    std::uint32_t const seed = GENERATE(range(1U, 13U));
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Camera const camera = small_camera();
    Pose pose = at_distance(1 + 0.3 * uniform(random));
    pose.translation.x() = 0.4 * uniform(random);
    pose.translation.y() = 0.3 * uniform(random);
    pose.rotation = Eigen::AngleAxisd(0.9 * uniform(random), Eigen::Vector3d::UnitX()).toRotationMatrix() *
                    Eigen::AngleAxisd(0.9 * uniform(random), Eigen::Vector3d::UnitY()).toRotationMatrix();
    int const neighbourhood = 3 + 2 * static_cast<int>(seed % 3);
    double const threshold = 0.02 * (seed % 5);
    RenderedObject const object = render(plate(0.1), pose, camera);
    Image<Feature> const found = features(object, camera, neighbourhood, threshold, 3);
    Image<Feature> const expected = features(cloud_of(object, camera, 3), neighbourhood, threshold);
    int points = 0;
    for (int row = 0; row < found.height(); ++row)
        for (int col = 0; col < found.width(); ++col) {
            CAPTURE(row, col);
            bool const is_bare = object.depth.at(row, col) == 0;
            REQUIRE((found.at(row, col) == Feature::none) == is_bare);
            if (is_bare)
                continue;
            REQUIRE(found.at(row, col) == expected.at(row + object.first_row, col + object.first_col));
            ++points;
        }
    CHECK(points > 20);
}

TEST_CASE("A pose that is the scene agrees with all of it, wherever it is", "[grip]") {
    std::uint32_t const seed = GENERATE(range(1U, 9U));
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Pose> poses;
    for (int i = 0; i < 6; ++i) {
        Pose pose = at_distance(1 + 0.2 * uniform(random));
        pose.translation.x() = 0.1 * uniform(random);
        pose.rotation = Eigen::AngleAxisd(0.4 * uniform(random), Eigen::Vector3d::UnitX()).toRotationMatrix() *
                        Eigen::AngleAxisd(0.4 * uniform(random), Eigen::Vector3d::UnitY()).toRotationMatrix();
        poses.push_back(pose);
    }
    Stimulus const stimulus = scene_of(plate(0.1), poses);
    std::vector<PoseScore> const scores = score_poses(stimulus, {}, 1);
    CHECK(scores[0].raw.points > 100);
    CHECK(scores[0].raw.ratio() > 0.99);
    std::vector<double> weights;
    for (PoseScore const& score : scores) {
        CHECK(score.edge.points + score.planar.points == score.raw.points);
        CHECK(score.raw.inliers <= score.raw.points);
        CHECK(score.edge.inliers + score.planar.inliers <= score.raw.inliers);
        weights.push_back(score.weight());
    }
    CHECK(best_of(weights) == 0);
    // As many threads as one likes.
    std::vector<PoseScore> const again = score_poses(stimulus, {}, 3);
    for (std::size_t i = 0; i < scores.size(); ++i)
        CHECK(again[i].weight() == scores[i].weight());
}

TEST_CASE("The outline of a plate is an edge, as it stands before a background", "[grip]") {
    Settings settings;
    settings.threshold = 0.2;  // more than being lopsided makes, less than 5 of 24 neighbours 3 m behind
    PoseScore const score = score_poses(scene_of(plate(0), {at_distance(1)}), settings, 1).at(0);
    // 21 x 21 pixels, of which 17 x 17 have all of their 5 x 5 neighbours on the plate.
    CHECK(score.raw.points == 441);
    CHECK(score.planar.points == 289);
}

TEST_CASE("Ranks share places among equals, and correlations are those by hand", "[grip]") {
    CHECK(ranks({3, 9, 9, 1}) == std::vector<double>{3, 1.5, 1.5, 4});
    CHECK(*rank_correlation({1, 2, 3, 4}, {10, 20, 30, 99}) == Approx(1));
    CHECK(*rank_correlation({1, 2, 3, 4}, {4, 3, 2, 1}) == Approx(-1));
    CHECK(*rank_correlation({1, 2, 3}, {1, 3, 2}) == Approx(0.5));  // 1 - 6 (0 + 1 + 1) / (3 x 8)
    CHECK_FALSE(rank_correlation({1, 1, 1}, {1, 2, 3}).has_value());
    CHECK(best_of({2, 7, 7}) == 1);
}

}  // namespace faster::grip::grip_test
