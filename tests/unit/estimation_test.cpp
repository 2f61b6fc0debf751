#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/models/builtin_models.hpp"
#include "poses/estimation/estimator.hpp"
#include "poses/estimation/first_samples.hpp"
#include "poses/estimation/icp.hpp"
#include "poses/estimation/resampling.hpp"
#include "poses/estimation/streams.hpp"
#include "poses/grip/rendered_object.hpp"

namespace estimation_test {

using namespace faster;
using namespace faster::estimation;

constexpr Resampling all_methods[]{Resampling::systematic, Resampling::stratified, Resampling::multinomial};

/// How often each index was drawn.
std::vector<double> copies_of(std::vector<double> const& shares, std::size_t count, Resampling method,
                              CounterRandom& random) {
    std::vector<double> copies(shares.size());
    for (std::size_t const index : resampled(shares, count, method, random))
        copies.at(index) += 1;
    return copies;
}

/// A can before a wall, of which the camera sees all.
Scene can_scene(double reading_m) {
    Scene scene;
    scene.observed.posed.mesh = models::make("tomato_soup_can");
    scene.observed.posed.camera = {160, 120, 140, 140, 79.5, 59.5};
    scene.observed.width = 160;
    scene.observed.height = 120;
    scene.observed.observed_depth =
        Image<std::uint16_t>(120, 160, static_cast<std::uint16_t>(std::floor(reading_m * 512)));
    scene.observed.observed_edges = Image<std::uint8_t>(120, 160);
    scene.size = size_of(scene.observed.posed.mesh);
    scene.boxes = {{60, 40, 20, 28, 1}};
    return scene;
}

Particle some_particle() {
    Particle particle;
    particle.middle = {0.05, -0.02, 0.7};
    particle.rotation = normalized({0.3, -0.5, 0.7, 0.2});
    return particle;
}

/// Weight falls with the distance from a place, and with the angle from a rotation.
Score closeness_to(Particle const& target) {
    return [target](std::vector<Particle> const& particles) {
        std::vector<WeightTerms> terms;
        for (Particle const& particle : particles) {
            WeightTerms term;
            term.raw = portable::exp(-20 * (particle.middle - target.middle).norm() -
                                     angle_between(particle.rotation, target.rotation));
            terms.push_back(term);
        }
        return terms;
    };
}

EstimatorConfig plain_config() {
    EstimatorConfig config;
    config.accelerator_weights = {0, 0, 1, 0, 0};
    return config;
}

TEST_CASE("Each method of resampling draws in proportion to the shares", "[estimation]") {
    Resampling const method = all_methods[GENERATE(0, 1, 2)];
    std::uint64_t const seed = GENERATE(range(1U, 6U));
    CAPTURE(static_cast<int>(method), seed);
    std::vector<double> const shares{0.07, 0.38, 0, 0.16, 0.27, 0.12};  // no whole copies: u decides
    constexpr std::size_t count = 20;
    int const rounds = 2000;
    std::vector<double> sums(shares.size());
    for (int round = 0; round < rounds; ++round) {
        CounterRandom random(seed, static_cast<std::uint64_t>(round), 0);
        std::vector<double> const copies = copies_of(shares, count, method, random);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += copies[i];
    }
    double chi_square = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        double const expected = shares[i] * count * rounds;
        if (shares[i] == 0)
            CHECK(sums[i] == 0);
        else
            chi_square += (sums[i] - expected) * (sums[i] - expected) / expected;
    }
    // 4 degrees of freedom: exceeded once in ten thousand by independent draws, which vary most.
    CHECK(chi_square < 23.5);
    if (method == Resampling::multinomial)
        CHECK(chi_square > 0.05);  // and below it once in thousands
}

TEST_CASE("Systematic resampling gives every index its share rounded up or down, stratified one more or less",
          "[estimation]") {
    std::uint64_t const seed = GENERATE(range(1U, 21U));
    CAPTURE(seed);
    CounterRandom random(seed, 0, 0);
    std::vector<double> weights;
    for (int i = 0; i < 40; ++i)
        weights.push_back(random.uniform());
    std::vector<double> const shares = shares_of(weights, 3);
    CHECK(std::accumulate(shares.begin(), shares.end(), 0.0) == Approx(1));
    std::vector<double> const systematic = copies_of(shares, 100, Resampling::systematic, random);
    std::vector<double> const stratified = copies_of(shares, 100, Resampling::stratified, random);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        CHECK(std::abs(systematic[i] - 100 * shares[i]) < 1);
        CHECK(std::abs(stratified[i] - 100 * shares[i]) < 2);
    }
}

TEST_CASE("Shares are powers of the weights, and all alike without weights", "[estimation]") {
    std::vector<double> const shares = shares_of({0.2, 0.4, 0}, 2);
    CHECK(shares[0] == Approx(0.2));
    CHECK(shares[1] == Approx(0.8));
    CHECK(shares[2] == 0);
    CHECK(shares_of({0, 0}, 8) == std::vector<double>{0.5, 0.5});
    CHECK(shares_of({0.1, 0.9}, 0) == std::vector<double>{0.5, 0.5});
    CHECK(shares_of({1e-300, 1e-300}, 50) == std::vector<double>{0.5, 0.5});
    CHECK(effective_sample_size({0.25, 0.25, 0.25, 0.25}) == 4);
    CHECK(effective_sample_size({1, 0, 0, 0}) == 1);
}

TEST_CASE("Noise has the configured deviations, and no direction is preferred", "[estimation]") {
    std::uint64_t const seed = GENERATE(1U, 2U, 3U);
    CAPTURE(seed);
    Particle const parent = some_particle();
    NoiseLevel const noise{0.01, 0.1};
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), squares = mean, axes = mean, products = mean;
    double angles = 0;
    int const draws = 20000;
    for (int i = 0; i < draws; ++i) {
        CounterRandom random = stream_of_sample(seed, 1, static_cast<std::size_t>(i));
        Particle const moved = diffused(parent, noise, random);
        Eigen::Vector3d const shift = moved.middle - parent.middle;
        mean += shift / draws;
        squares += shift.cwiseAbs2() / draws;
        products += Eigen::Vector3d(shift.x() * shift.y(), shift.y() * shift.z(), shift.z() * shift.x()) / draws;
        Eigen::AngleAxisd const turn(Eigen::Matrix3d(moved.rotation.matrix() * parent.rotation.matrix().transpose()));
        angles += turn.angle() * turn.angle() / draws;
        axes += turn.axis().cwiseAbs2() / draws;
        REQUIRE(dot(moved.rotation, moved.rotation) == Approx(1).epsilon(1e-14));
    }
    CHECK(std::sqrt(angles) == Approx(0.1).epsilon(0.03));
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(mean[axis] == Approx(0).margin(4 * 0.01 / std::sqrt(draws)));
        CHECK(std::sqrt(squares[axis]) == Approx(0.01).epsilon(0.03));
        CHECK(products[axis] == Approx(0).margin(4e-4 / std::sqrt(draws)));
        CHECK(axes[axis] == Approx(1.0 / 3).epsilon(0.03));
    }
}

TEST_CASE("Noise decays to its least deviation", "[estimation]") {
    DiffusionConfig config;
    config.translation_sigma_m = 0.02;
    config.translation_sigma_min_m = 0.003;
    config.rotation_sigma_deg = 40;
    config.rotation_sigma_min_deg = 9;
    config.decay = 0.5;
    CHECK(noise_of(config, 0).translation_m == 0.02);
    CHECK(noise_of(config, 2).translation_m == 0.005);
    CHECK(noise_of(config, 3).translation_m == 0.003);
    CHECK(noise_of(config, 2).rotation_rad == Approx(10 * M_PI / 180));
    CHECK(noise_of(config, 100000).rotation_rad == Approx(9 * M_PI / 180));
}

TEST_CASE("Rotations are uniform on SO(3)", "[estimation]") {
    std::uint64_t const seed = GENERATE(range(1U, 6U));
    CAPTURE(seed);
    CounterRandom random(seed, 0, 0);
    constexpr int bins = 20, draws = 20000;
    double angle_bins[bins] = {}, height_bins[bins] = {}, cells[8] = {};
    Rotation const fixed = some_particle().rotation;
    for (int i = 0; i < draws; ++i) {
        Rotation const rotation = uniform_rotation(random);
        // The angle to any rotation has the distribution (a - sin a) / pi; an axis goes to all directions alike.
        double const angle = angle_between(rotation, fixed);
        ++angle_bins[std::min(bins - 1, static_cast<int>((angle - std::sin(angle)) / M_PI * bins))];
        double const height = rotation.matrix()(2, 1);
        ++height_bins[std::min(bins - 1, static_cast<int>((height + 1) / 2 * bins))];
        ++cells[(rotation.w * rotation.x > 0 ? 1 : 0) + (rotation.w * rotation.y > 0 ? 2 : 0) +
                (rotation.w * rotation.z > 0 ? 4 : 0)];
    }
    double of_angles = 0, of_heights = 0, of_cells = 0;
    int const a_bin = draws / bins, a_cell = draws / 8;
    for (int bin = 0; bin < bins; ++bin) {
        of_angles += std::pow(angle_bins[bin] - a_bin, 2) / a_bin;
        of_heights += std::pow(height_bins[bin] - a_bin, 2) / a_bin;
    }
    for (double const cell : cells)
        of_cells += std::pow(cell - a_cell, 2) / a_cell;
    CHECK(of_angles < 50.8);  // 19 degrees of freedom, once in ten thousand
    CHECK(of_heights < 50.8);
    CHECK(of_cells < 29.9);  // 7
}

TEST_CASE("Quaternions and matrices say the same", "[estimation]") {
    CounterRandom random(5, 0, 0);
    for (int i = 0; i < 200; ++i) {
        Rotation const a = uniform_rotation(random), b = uniform_rotation(random);
        REQUIRE((a.matrix() * a.matrix().transpose()).isIdentity(1e-12));
        REQUIRE(a.matrix().determinant() == Approx(1));
        REQUIRE(product(a, b).matrix().isApprox(a.matrix() * b.matrix(), 1e-12));
        REQUIRE(rotation_of(a.matrix()).matrix().isApprox(a.matrix(), 1e-12));
        Eigen::AngleAxisd const turn(Eigen::Matrix3d(a.matrix() * b.matrix().transpose()));
        REQUIRE(angle_between(a, b) == Approx(turn.angle()).margin(1e-7));
    }
    CHECK(angle_between({1, 0, 0, 0}, {-1, 0, 0, 0}) == 0);
}

TEST_CASE("A particle's pose has the middle of the object where the particle is", "[estimation]") {
    Mesh mesh = models::make("mug");
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += Eigen::Vector3d(0.3, 0.2, -0.1);
    ObjectSize const size = size_of(mesh);
    Particle const particle = some_particle();
    Pose const pose = pose_of(particle, size);
    CHECK((pose.rotation * size.middle + pose.translation).isApprox(particle.middle, 1e-12));
    CHECK(size.least_extent > 0.05);
    CHECK(size.diameter > size.least_extent);
    CHECK(size.outline.size() > 8);
    CHECK(size.outline.size() <= 26);
    Camera const camera{640, 480, 570, 570, 319.5, 239.5};
    CHECK(overlap_share(box_around(size.outline, pose, camera), box_around(mesh.vertices, pose, camera)) > 0.8);
    Particle behind = particle;
    behind.middle.z() = -2;
    CHECK(pose_of(behind, size).translation.z() == 0.1);
}

TEST_CASE("A mesh is moved to its middle, and poses are told in its own frame", "[estimation]") {
    Scene scene = can_scene(0.6);
    for (Eigen::Vector3d& vertex : scene.observed.posed.mesh.vertices)
        vertex += Eigen::Vector3d(0.04, -0.08, 0.06);
    Mesh const own = scene.observed.posed.mesh;
    centre_mesh(scene);
    CHECK(scene.size.middle.norm() < 1e-12);
    Pose const pose = pose_of(some_particle(), scene.size);
    CHECK(pose.translation.isApprox(some_particle().middle, 1e-12));
    Pose const told = scene.own(pose);
    for (std::size_t i = 0; i < own.vertices.size(); i += 50)
        CHECK((told.rotation * own.vertices[i] + told.translation)
                  .isApprox(pose.rotation * scene.observed.posed.mesh.vertices[i] + pose.translation, 1e-12));
    CHECK(scene.centred(told).translation.isApprox(pose.translation, 1e-12));
}

TEST_CASE("First samples lie in the box, a little behind a reading, and turn everywhere", "[estimation]") {
    Scene const scene = can_scene(0.6);
    std::vector<Particle> const particles = first_samples(scene, 500, 3);
    REQUIRE(particles.size() == 500);
    double columns = 0;
    Camera const& camera = scene.observed.posed.camera;
    for (Particle const& particle : particles) {
        double const col = particle.middle.x() / particle.middle.z() * camera.fx + camera.cx;
        double const row = particle.middle.y() / particle.middle.z() * camera.fy + camera.cy;
        REQUIRE((col >= 60 && col < 80 && row >= 40 && row < 68));
        double const behind = particle.middle.z() - 0.6;
        REQUIRE((behind > scene.size.least_extent / 2 - 0.002 && behind < scene.size.diameter / 2 + 0.002));
        columns += col / 500;
    }
    CHECK(columns == Approx(70).margin(1));
    std::vector<Particle> const fewer = first_samples(scene, 10, 3);
    for (std::size_t i = 0; i < fewer.size(); ++i)
        CHECK(fewer[i].middle == particles[i].middle);
    CHECK(first_samples(scene, 1, 4)[0].middle != particles[0].middle);
}

TEST_CASE("First samples without readings go by the object's size, and without a box by all of the image",
          "[estimation]") {
    Scene blind = can_scene(0);
    for (Particle const& particle : first_samples(blind, 50, 1))
        // The can's diameter fills the 28 rows of the box.
        CHECK(particle.middle.z() == Approx(140 * blind.size.diameter / 28));
    Scene unknown = can_scene(0.6);
    unknown.boxes.clear();
    double least = 160, most = 0;
    for (Particle const& particle : first_samples(unknown, 200, 1)) {
        double const col = particle.middle.x() / particle.middle.z() * 140 + 79.5;
        least = std::min(least, col);
        most = std::max(most, col);
    }
    CHECK(least < 30);
    CHECK(most > 130);
}

TEST_CASE("Samples come from each of several boxes as often as their confidences say", "[estimation]") {
    Scene scene = can_scene(0.6);
    scene.boxes = {{10, 10, 20, 20, 0.2}, {100, 60, 20, 20, 0.6}};
    int second = 0;
    for (Particle const& particle : first_samples(scene, 2000, 9))
        second += particle.box == 1 ? 1 : 0;
    CHECK(second == Approx(1500).margin(100));
}

TEST_CASE("The loop finds what its scores point to, and never loses the best sample", "[estimation]") {
    Resampling const method = all_methods[GENERATE(0, 1, 2)];
    std::uint64_t const seed = GENERATE(1U, 2U, 3U);
    CAPTURE(static_cast<int>(method), seed);
    Scene const scene = can_scene(0.6);
    Particle target = some_particle();
    target.middle = {-0.04, -0.03, 0.66};
    EstimatorConfig config = plain_config();
    config.resampling = method;
    config.seed = seed;
    std::vector<Iteration> iterations;
    estimation::Estimate const found = estimate(scene, config, 200, closeness_to(target),
                                                [&](Iteration const& iteration) { iterations.push_back(iteration); });
    REQUIRE(iterations.size() == 50);
    CHECK(found.iterations == 50);
    CHECK(found.ending == Ending::iterations);
    CHECK((found.particle.middle - target.middle).norm() < 0.005);
    CHECK(angle_between(found.particle.rotation, target.rotation) < 0.1);
    CHECK(found.weight == iterations.back().best_weight());
    for (std::size_t k = 1; k < iterations.size(); ++k) {
        Particle const& kept = iterations[k - 1].particles[iterations[k - 1].best];
        REQUIRE(iterations[k].particles.size() == 200);
        REQUIRE(iterations[k].particles[0].middle == kept.middle);
        REQUIRE(dot(iterations[k].particles[0].rotation, kept.rotation) == dot(kept.rotation, kept.rotation));
        REQUIRE(iterations[k].best_weight() >= iterations[k - 1].best_weight());
        CHECK(iterations[k].noise.translation_m == noise_of(config.diffusion, k - 1).translation_m);
    }
    CHECK(iterations.back().spread_m < iterations.front().spread_m);
}

TEST_CASE("The loop ends with the first iteration that reaches stop_weight", "[estimation]") {
    EstimatorConfig config = plain_config();
    config.stop_weight = 0.5;
    estimation::Estimate const found = estimate(can_scene(0.6), config, 100, closeness_to(some_particle()));
    CHECK(found.ending == Ending::stop_weight);
    CHECK(found.iterations < 50);
    CHECK(found.weight >= 0.5);
    config.stop_weight = 0;
    CHECK(estimate(can_scene(0.6), config, 100, closeness_to(some_particle())).iterations == 1);
}

TEST_CASE("Runs know nothing of each other, and the heaviest is kept", "[estimation]") {
    EstimatorConfig config = plain_config();
    config.iterations = 4;
    config.restarts = 4;
    Scene const scene = can_scene(0.6);
    Score const score = closeness_to(some_particle());
    std::vector<Iteration> iterations;
    estimation::Estimate const found =
        estimate(scene, config, 30, score, [&](Iteration const& iteration) { iterations.push_back(iteration); });
    REQUIRE(iterations.size() == 16);
    CHECK(found.iterations == 16);
    CHECK(found.runs == 4);
    EstimatorConfig alone = config;
    alone.restarts = 1;
    double heaviest = 0;
    for (std::uint64_t run = 0; run < 4; ++run) {
        alone.seed = config.seed + run;
        estimation::Estimate const own = estimate(scene, alone, 30, score);
        CAPTURE(run);
        CHECK(iterations[4 * run].number == 0);
        CHECK(iterations[4 * run + 3].run == run);
        CHECK(iterations[4 * run + 3].best_weight() == own.weight);
        CHECK((found.run == run) == (own.weight == found.weight));
        heaviest = std::max(heaviest, own.weight);
    }
    CHECK(found.weight == heaviest);
    CHECK(found.run != 0);  // otherwise these seeds say nothing: take others
    config.stop_weight = iterations.front().best_weight();
    CHECK(estimate(scene, config, 30, score).iterations == 1);
}

/// A box of which the camera sees three sides, before a wall; `hidden_cols` columns of the image are nearer.
Stimulus box_before_wall(Pose const& pose, int hidden_cols) {
    Stimulus observed;
    observed.posed.mesh = models::make("cracker_box");
    observed.posed.camera = {320, 240, 500, 500, 159.5, 119.5};
    observed.width = 320;
    observed.height = 240;
    observed.fraction.depth_buffer = 9;
    observed.observed_depth = Image<std::uint16_t>(240, 320, 614);
    grip::RenderedObject const object = grip::render(observed.posed.mesh, pose, observed.posed.camera);
    for (int row = 0; row < object.depth.height(); ++row)
        for (int col = 0; col < object.depth.width(); ++col)
            if (object.depth.at(row, col) > 0)
                observed.observed_depth.at(row + object.first_row, col + object.first_col) =
                    static_cast<std::uint16_t>(std::floor(object.depth.at(row, col) * 512));
    for (int row = 0; row < 240; ++row)
        for (int col = 0; col < hidden_cols; ++col)
            observed.observed_depth.at(row, col) = static_cast<std::uint16_t>(0.4 * 512);
    return observed;
}

double mean_distance(Mesh const& mesh, Pose const& a, Pose const& b) {
    double sum = 0;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        sum += (a.rotation * vertex + a.translation - b.rotation * vertex - b.translation).norm();
    return sum / static_cast<double>(mesh.vertices.size());
}

TEST_CASE("ICP brings a pose that is nearly right closer, and of an object of which half is hidden no further off",
          "[estimation]") {
    Pose truth;
    truth.rotation =
        (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
    truth.translation = {0.02, -0.01, 0.8};
    Pose start = truth;
    start.translation += Eigen::Vector3d(0.006, -0.005, 0.006);
    start.rotation = Eigen::AngleAxisd(0.05, Eigen::Vector3d(1, 2, -1).normalized()) * start.rotation;
    int const hidden_cols = GENERATE(0, 165);
    CAPTURE(hidden_cols);
    Stimulus const observed = box_before_wall(truth, hidden_cols);
    double const before = mean_distance(observed.posed.mesh, start, truth);
    double const after = mean_distance(observed.posed.mesh, refined_by_icp(observed, start), truth);
    CAPTURE(before, after);
    CHECK(before > 0.008);
    CHECK(after <= (hidden_cols == 0 ? 0.002 : before));
}

TEST_CASE("ICP leaves a pose as it is where no reading is near, and where there is none at all", "[estimation]") {
    Pose pose;
    pose.translation = {0.02, -0.01, 0.8};
    Stimulus observed = box_before_wall(pose, 320);
    CHECK(refined_by_icp(observed, pose).translation == pose.translation);
    CHECK(refined_by_icp(observed, pose).rotation == pose.rotation);
    observed.observed_depth = Image<std::uint16_t>(240, 320, 0);
    CHECK(refined_by_icp(observed, pose).translation == pose.translation);
}

TEST_CASE("The same seed gives the same estimate, another seed another, and scores of 0 are no trouble",
          "[estimation]") {
    EstimatorConfig config = plain_config();
    config.iterations = 5;
    Scene const scene = can_scene(0.6);
    Score const nothing = [](std::vector<Particle> const& particles) {
        return std::vector<WeightTerms>(particles.size());
    };
    Particle const a = estimate(scene, config, 50, nothing).particle;
    Particle const b = estimate(scene, config, 50, nothing).particle;
    CHECK(a.middle == b.middle);
    config.seed += 1;
    CHECK(estimate(scene, config, 50, nothing).particle.middle != a.middle);
    CHECK(estimate(scene, config, 1, nothing).weight == 0);
}

TEST_CASE("The mean of a cluster weighs its poses and leaves out the others", "[estimation]") {
    EstimatorConfig config = plain_config();
    config.sharpness = 1;
    Iteration iteration;
    Particle const best = some_particle();
    Particle left = best, right = best, far = best, turned = best;
    left.middle.x() -= 0.004;
    right.middle.x() += 0.002;
    right.rotation = {-best.rotation.w, -best.rotation.x, -best.rotation.y, -best.rotation.z};  // the same rotation
    far.middle.x() += 1;
    turned.rotation = product({0, 1, 0, 0}, best.rotation);
    iteration.particles = {best, left, right, far, turned};
    iteration.weights = {0.4, 0.1, 0.2, 0.35, 0.35};
    iteration.best = 0;
    Particle const mean = cluster_mean(iteration, config);
    CHECK(mean.middle.x() - best.middle.x() == Approx((-0.1 * 0.004 + 0.2 * 0.002) / 0.7).margin(1e-12));
    CHECK(angle_between(mean.rotation, best.rotation) < 1e-6);
    config.iterations = 30;
    config.estimate = EstimateKind::mean;
    Particle target = best;
    target.middle = {-0.04, -0.03, 0.66};
    estimation::Estimate const found = estimate(can_scene(0.6), config, 200, closeness_to(target));
    CHECK((found.particle.middle - target.middle).norm() < 0.02);
}

TEST_CASE("Eq. 2.4 by hand, of counters and of GRIP's clouds", "[estimation]") {
    SampleCounters counters;
    counters.valid_raster = 400;
    counters.inlier = 100;
    counters.valid_edge = 50;
    counters.edge_inlier = 10;
    BoxFit const fit{0.8, 0.9};
    TermSettings const from_100{InBoxTerm::overlap, 100};
    WeightTerms const terms = terms_of(counters, 0.5, fit, from_100);
    CHECK(terms.raw == 0.25);
    CHECK(terms.edge == 0.2);
    CHECK(terms.in_box == Approx(0.2));
    CHECK(terms.weight({0.1, 0.2, 0.3, 0.4, 0}) == Approx(0.1 * 0.5 + 0.2 * 0.2 + 0.3 * 0.25 + 0.4 * 0.2));
    CHECK(terms_of(counters, 0.5, fit, {InBoxTerm::overlap, 401}).weight({0.1, 0, 0.4, 0.5, 0}) == Approx(0.05));
    counters.inlier = 500;  // contour pixels count too
    CHECK(terms_of(counters, 0.5, fit, from_100).raw == 1);
    CHECK(terms_of(SampleCounters{}, 0, {1, 1}, {}).raw == 0);
    grip::PoseScore score;
    score.raw = {400, 100};
    score.edge = {40, 20};
    score.planar = {360, 90};
    score.in_box = {200, 80};
    CHECK(terms_of(score, 1, {}, {InBoxTerm::box_points, 0}).weight({0.1, 0.2, 0.3, 0.25, 0.15}) ==
          Approx(0.1 + 0.2 * 0.4 + 0.3 * 0.25 + 0.25 * 0.5 + 0.15 * 0.25));
    CHECK(terms_of(score, 1, {}, {InBoxTerm::box_points, 401}).weight({0.1, 0.2, 0.3, 0.25, 0.15}) == Approx(0.1));
}

TEST_CASE("Hidden pixels are no drawn ones, as far as the weight is told so", "[estimation]") {
    SampleCounters counters;
    counters.valid_raster = 400;
    counters.inlier = 60;
    counters.hidden = 200;
    BoxFit const fit{0.5, 0.5};
    CHECK(terms_of(counters, 1, fit, {InBoxTerm::overlap, 0}).raw == Approx(60.0 / 400));
    CHECK(terms_of(counters, 1, fit, {InBoxTerm::overlap, 0, 0.5}).raw == Approx(60.0 / 300));
    CHECK(terms_of(counters, 1, fit, {InBoxTerm::overlap, 0, 0.5}).in_box == Approx(0.5 * 60.0 / 300));
    CHECK(terms_of(counters, 1, fit, {InBoxTerm::overlap, 0, 1}).raw == Approx(60.0 / 200));
    counters.hidden = 400;
    CHECK(terms_of(counters, 1, fit, {InBoxTerm::overlap, 0, 1}).raw == 0);  // nothing is left to look for
}

TEST_CASE("The box of drawn, not hidden pixels lies in the image where the sample's window does", "[estimation]") {
    SampleInput sample;
    sample.centre_row = 120;
    sample.centre_col = 90;
    SampleCounters counters;
    CHECK(visible_box(counters, sample, 201).width == 0);
    counters.visible_top = 10;
    counters.visible_bottom = 29;
    counters.visible_left = 40;
    counters.visible_right = 40;
    DetectionConfig const box = visible_box(counters, sample, 201);
    CHECK(box.top == 30);
    CHECK(box.height == 20);
    CHECK(box.left == 30);
    CHECK(box.width == 1);
}

TEST_CASE("I_b is had in the same four ways from counters and from GRIP's clouds", "[estimation]") {
    SampleCounters counters;
    counters.valid_raster = 400;
    counters.inlier = 100;
    grip::PoseScore score;
    score.raw = {400, 100};
    score.in_box = {200, 80};
    BoxFit const fit{0.4, 0.5}, apart{0, 0};
    auto const counted = [&](InBoxTerm term, BoxFit const& of) { return terms_of(counters, 1, of, {term, 0}).in_box; };
    auto const by_grip = [&](InBoxTerm term) { return terms_of(score, 1, fit, {term, 0}).in_box; };
    CHECK(counted(InBoxTerm::overlap, fit) == Approx(0.25 * 0.4));
    CHECK(by_grip(InBoxTerm::overlap) == Approx(0.25 * 0.4));
    CHECK(counted(InBoxTerm::all_points, fit) == Approx(0.25 * 0.5));
    CHECK(by_grip(InBoxTerm::all_points) == Approx(80.0 / 400));
    CHECK(counted(InBoxTerm::box_points, fit) == Approx(0.25));
    CHECK(counted(InBoxTerm::box_points, apart) == 0);
    CHECK(by_grip(InBoxTerm::box_points) == Approx(80.0 / 200));
    CHECK(counted(InBoxTerm::none, fit) == 0);
    CHECK(by_grip(InBoxTerm::none) == 0);
}

TEST_CASE("Without I_b the other coefficients keep their proportions and add up to 1", "[estimation]") {
    EstimatorConfig config;
    config.accelerator_weights = {0.1, 0.5, 0.3, 0.1, 0};
    CHECK(config.coefficients().in_box == 0.5);
    config.in_box = InBoxTerm::none;
    WeightCoefficients const left = config.coefficients();
    CHECK(left.box == Approx(0.2));
    CHECK(left.in_box == 0);
    CHECK(left.raw == Approx(0.6));
    CHECK(left.edge == Approx(0.2));
    config.backend = EstimatorBackend::grip;
    WeightCoefficients const of_grip = config.coefficients();
    CHECK(of_grip.box + of_grip.raw + of_grip.edge + of_grip.planar == Approx(1));
}

TEST_CASE("The box around an object ends at the image, and an object outside has none", "[estimation]") {
    Mesh const mesh = models::make("tomato_soup_can");
    Camera const camera{160, 120, 140, 140, 79.5, 59.5};
    Pose pose;
    pose.translation = {0, 0, 0.5};
    DetectionConfig const box = box_around(mesh.vertices, pose, camera);
    CHECK(box.width > 10);
    CHECK(box.left + box.width / 2 == Approx(79.5).margin(1));
    pose.translation.x() = 0.5 * 80 / 140;
    CHECK(box_around(mesh.vertices, pose, camera).left + box_around(mesh.vertices, pose, camera).width <= 159);
    pose.translation.x() = 2;
    CHECK(box_around(mesh.vertices, pose, camera).width == 0);
    CHECK(overlap_share({0, 0, 4, 4, 1}, {2, 2, 4, 4, 1}) == Approx(4.0 / 28));
    CHECK(overlap_share({0, 0, 4, 4, 1}, {0, 0, 4, 4, 1}) == 1);
    CHECK(overlap_share({0, 0, 4, 4, 1}, {5, 0, 4, 4, 1}) == 0);
    CHECK(overlap_share({}, {}) == 0);
    CHECK(share_inside({0, 0, 4, 4, 1}, {2, 2, 4, 4, 1}) == Approx(4.0 / 16));
    CHECK(share_inside({0, 0, 4, 4, 1}, {-1, -1, 9, 9, 1}) == 1);
    CHECK(share_inside({}, {0, 0, 4, 4, 1}) == 0);
    CHECK(overlaps({-5, -5, 6, 6, 1}, 160, 120));
    CHECK_FALSE(overlaps({-5, -5, 5, 6, 1}, 160, 120));
    CHECK_FALSE(overlaps({160, 0, 5, 6, 1}, 160, 120));
    CHECK(readings_in({-5, -5, 7, 6, 1}, Image<std::uint16_t>(120, 160, 9)) == 2);
    CHECK(readings_in({300, 5, 7, 6, 1}, Image<std::uint16_t>(120, 160, 9)) == 0);
}

}  // namespace estimation_test
