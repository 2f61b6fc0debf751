#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/reference/scorer.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/models/builtin_models.hpp"
#include "faster/workload/object_mesh.hpp"
#include "support/counters.hpp"
#include "support/random_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::model_vs_reference_test {

/// Those that are not the default, which all other tests here use.
constexpr EdgeMapAlgorithm other_algorithms[] = {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition,
                                                 EdgeMapAlgorithm::bounded, EdgeMapAlgorithm::dual_map_4_1_2,
                                                 EdgeMapAlgorithm::inner_border};

/// Uniform over all rotations.
Eigen::Matrix3d random_rotation(Random& random) {
    double const w = random.normal();
    double const x = random.normal();
    double const y = random.normal();
    double const z = random.normal();
    return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

/// 0.5 to 0.9 m away, anywhere in the image; objects near its border are cut off.
Pose random_pose(Random& random, Camera const& camera) {
    Pose pose;
    pose.rotation = random_rotation(random);
    double const z = 0.5 + 0.4 * random.uniform();
    double const col = random.uniform() * (camera.width - 1);
    double const row = random.uniform() * (camera.height - 1);
    pose.translation = Eigen::Vector3d((col - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z);
    return pose;
}

/// Depths around the objects', holes and far readings among them, and edges: noise, so that every test of a pixel goes
/// both ways.
void fill_observation(Random& random, Stimulus& stimulus) {
    stimulus.observed_depth = Image<std::uint16_t>(stimulus.height, stimulus.width);
    stimulus.observed_edges = Image<std::uint8_t>(stimulus.height, stimulus.width);
    double const metre = std::ldexp(1.0, stimulus.fraction.depth_buffer);
    for (std::uint16_t& code : stimulus.observed_depth.pixels()) {
        double const kind = random.uniform();
        double const depth = random.uniform();
        code = kind < 0.1   ? std::uint16_t{0}
               : kind < 0.2 ? static_cast<std::uint16_t>(far_depth_code * depth)
                            : static_cast<std::uint16_t>(metre * (0.45 + 0.5 * depth));
    }
    for (std::uint8_t& edge : stimulus.observed_edges.pixels())
        edge = random.uniform() < 0.3 ? 1 : 0;
}

Stimulus posed_stimulus(Mesh mesh, std::size_t poses, std::uint64_t seed) {
    Random random(seed);
    Stimulus stimulus;
    Camera const& camera = stimulus.posed.camera;
    stimulus.width = camera.width;
    stimulus.height = camera.height;
    stimulus.posed.mesh = std::move(mesh);
    fill_observation(random, stimulus);
    for (std::size_t i = 0; i < poses; ++i) {
        Pose const pose = random_pose(random, camera);
        Eigen::Vector3d const& origin = pose.translation;
        SampleInput sample;
        sample.centre_col = static_cast<std::int32_t>(std::floor(camera.fx * origin.x() / origin.z() + camera.cx));
        sample.centre_row = static_cast<std::int32_t>(std::floor(camera.fy * origin.y() / origin.z() + camera.cy));
        sample.triangle_count = static_cast<std::uint32_t>(stimulus.posed.mesh.faces.size());
        stimulus.samples.push_back(sample);
        stimulus.posed.poses.push_back(pose);
    }
    return stimulus;
}

/// Where two pictures differ first; empty if they do not.
template <class Pixel> std::string first_difference(Image<Pixel> const& model, Image<Pixel> const& reference) {
    if (model.height() != reference.height() || model.width() != reference.width())
        return "another size: " + std::to_string(model.height()) + " x " + std::to_string(model.width());
    for (int row = 0; row < model.height(); ++row)
        for (int col = 0; col < model.width(); ++col)
            if (model.at(row, col) != reference.at(row, col))
                return "row " + std::to_string(row) + ", column " + std::to_string(col) + ": " +
                       std::to_string(model.at(row, col)) + " against " + std::to_string(reference.at(row, col));
    return {};
}

/// Returns the sum of the reference's valid_raster, so that a caller can tell that something was drawn.
std::uint64_t check_model(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine) {
    TestRun const run = test_run(config, stimulus, engine, {true});
    REQUIRE_FALSE(run.statistics.deadlocked());
    REQUIRE(run.statistics.samples.size() == stimulus.samples.size());
    REQUIRE(run.maps.size() == stimulus.samples.size());
    reference::Scorer scorer = config.flow == Flow::fpga_grip ? reference::Scorer(stimulus, config.edge_extraction)
                                                              : reference::Scorer(stimulus, config.edge_map);
    if (config.inlier_unit.hidden == HiddenPixels::counted)
        scorer.count_hidden();
    std::uint64_t drawn = 0;
    for (std::size_t sample = 0; sample < stimulus.samples.size(); ++sample) {
        CAPTURE(sample);
        SampleCounters const counters = scorer.run(sample);
        CHECK(run.statistics.samples[sample].sample == sample);
        SampleCounters const found = counters_of(run.statistics.samples[sample]);
        CHECK(found.valid_raster == counters.valid_raster);
        CHECK(found.valid_depth == counters.valid_depth);
        CHECK(found.inlier == counters.inlier);
        CHECK(found.valid_edge == counters.valid_edge);
        CHECK(found.edge_inlier == counters.edge_inlier);
        CHECK(values_of(found) == values_of(counters));
        CHECK(first_difference(run.maps[sample].edge_map, scorer.maps().edge_map) == "");
        CHECK(first_difference(run.maps[sample].object_map, scorer.maps().object_map) == "");
        CHECK(first_difference(run.maps[sample].depth_buffer, scorer.maps().depth_buffer) == "");
        drawn += counters.valid_raster;
    }
    return drawn;
}

/// Traces of `stimuli` seeds, `options.samples` each, under random machines; every tenth in lockstep as well.
void check_traces(std::uint64_t first_seed, std::uint64_t stimuli, RandomStimulusOptions options,
                  EdgeMapAlgorithm algorithm = EdgeMapAlgorithm::dual_map, bool any_scan = false,
                  Flow flow = Flow::faster) {
    for (std::uint64_t seed = first_seed; seed < first_seed + stimuli; ++seed) {
        CAPTURE(seed);
        options.random_fraction_bits = seed % 2 == 1;
        Stimulus const stimulus = random_stimulus(seed, options);
        RandomConfigOptions machine;
        machine.cores = {1, 3};
        machine.algorithm = algorithm;
        machine.any_scan = any_scan;
        machine.flow = flow;
        machine.any_clearing = algorithm != EdgeMapAlgorithm::dual_map || flow != Flow::faster;
        machine.any_partition = machine.any_clearing;
        machine.max_lanes = machine.any_clearing ? std::min(stimulus.window, 9) : 1;
        bool const may_scan_groups = algorithm == EdgeMapAlgorithm::inner_border || flow == Flow::fpga_grip;
        machine.max_scan_lanes = any_scan && may_scan_groups && seed % 2 == 0 ? 12 : 1;
        machine.any_region = true;
        machine.any_buffers = true;
        AcceleratorConfig config = random_config(seed, machine);
        config.inlier_unit.hidden = seed % 4 < 2 ? HiddenPixels::counted : HiddenPixels::ignored;
        adopt(stimulus, config);
        check_model(config, stimulus, Engine::decoupled);
        if (seed % 10 == 0)
            check_model(config, stimulus, Engine::lockstep);
    }
}

AcceleratorConfig machine_of_seed(std::uint64_t seed) {
    AcceleratorConfig config;
    config.cores = 1 + seed % 3;
    config.edge_map.flush_last = seed % 2 == 1;
    config.inlier_unit.hidden = seed % 4 == 3 ? HiddenPixels::counted : HiddenPixels::ignored;
    return config;
}

void check_builtin_models(std::size_t first, std::size_t stride) {
    std::vector<std::string> const names = models::names();
    REQUIRE(names.size() == 21);
    for (std::size_t i = first; i < names.size(); i += stride) {
        std::uint64_t const seed = 100 + i;
        CAPTURE(names[i], seed);
        Stimulus const stimulus = posed_stimulus(models::make(names[i]), 40, seed);
        CHECK(check_model(machine_of_seed(seed), stimulus, Engine::decoupled) > 40 * 100);
    }
}

TEST_CASE("Model and reference agree on the built-in classes 0, 3, 6, ...", "[golden]") { check_builtin_models(0, 3); }
TEST_CASE("Model and reference agree on the built-in classes 1, 4, 7, ...", "[golden]") { check_builtin_models(1, 3); }
TEST_CASE("Model and reference agree on the built-in classes 2, 5, 8, ...", "[golden]") { check_builtin_models(2, 3); }

TEST_CASE("The lockstep model and the reference agree on a built-in class", "[golden]") {
    Stimulus const stimulus = posed_stimulus(models::make("mug"), 2, 200);
    CHECK(check_model(machine_of_seed(1), stimulus, Engine::lockstep) > 0);
}

TEST_CASE("Model and reference agree on 2,000 traces of random triangles", "[golden]") {
    RandomStimulusOptions options;
    options.samples = {10, 10};
    check_traces(10000, 200, options);
}

TEST_CASE("Model and reference agree on every kind of triangle", "[golden]") {
    for (int kind = 0; kind < triangle_kind_count; ++kind) {
        CAPTURE(kind);
        RandomStimulusOptions options;
        options.kind = static_cast<TriangleKind>(kind);
        options.samples = {10, 10};
        options.triangles = {1, 20};
        check_traces(20000 + 10 * static_cast<std::uint64_t>(kind), 4, options);
    }
}

TEST_CASE("Model and reference agree on random triangles in windows of 200", "[golden]") {
    RandomStimulusOptions options;
    options.width = {160, 640};
    options.height = {120, 480};
    options.window = {200, 200};
    options.samples = {4, 4};
    options.triangles = {0, 60};
    check_traces(30000, 10, options);
}

TEST_CASE("Model and reference agree with every edge map algorithm", "[golden][edge_map]") {
    std::uint64_t seed = 40000;
    for (EdgeMapAlgorithm const algorithm : other_algorithms) {
        CAPTURE(static_cast<int>(algorithm));
        RandomStimulusOptions options;
        options.samples = {8, 8};
        check_traces(seed, 40, options, algorithm);
        options.window = {200, 200};
        options.width = {160, 640};
        options.height = {120, 480};
        options.triangles = {0, 60};
        check_traces(seed + 50, 2, options, algorithm);
        seed += 100;
    }
}

TEST_CASE("Model and reference agree however triangles are prepared and scanned", "[golden][scan]") {
    std::uint64_t seed = 41000;
    for (std::size_t i = 0; i < 6; ++i) {
        auto const algorithm = static_cast<EdgeMapAlgorithm>(i);
        for (std::optional<TriangleKind> const kind :
             {std::optional<TriangleKind>(), std::optional(TriangleKind::Sliver), std::optional(TriangleKind::Huge),
              std::optional(TriangleKind::WholePixels)}) {
            CAPTURE(i, kind.has_value());
            RandomStimulusOptions options;
            options.samples = {8, 8};
            options.kind = kind;
            check_traces(seed, 10, options, algorithm, true);
            seed += 10;
        }
    }
}

TEST_CASE("Model and reference agree on built-in classes with every scan", "[golden][scan]") {
    for (char const* const name : {"cracker_box", "banana", "scissors"}) {
        Stimulus const stimulus = posed_stimulus(models::make(name), 10, 600);
        for (ScanPolicy const scan : {ScanPolicy::zigzag, ScanPolicy::early_exit, ScanPolicy::spans}) {
            CAPTURE(name, static_cast<int>(scan));
            AcceleratorConfig config = machine_of_seed(1);
            config.rasterizer = {scan, 5};
            config.inlier_unit.fragment_loop = FragmentLoop::flattened;
            CHECK(check_model(config, stimulus, Engine::decoupled) > 10 * 100);
        }
    }
}

TEST_CASE("Model and reference agree on built-in classes with every edge map algorithm", "[golden][edge_map]") {
    for (char const* const name : {"cracker_box", "banana", "tomato_soup_can", "mug", "scissors"}) {
        Stimulus const stimulus = posed_stimulus(models::make(name), 10, 500);
        for (EdgeMapAlgorithm const algorithm : other_algorithms) {
            CAPTURE(name, static_cast<int>(algorithm));
            AcceleratorConfig config = machine_of_seed(1);
            config.edge_map.algorithm = algorithm;
            CHECK(check_model(config, stimulus, Engine::decoupled) > 10 * 100);
        }
    }
}

TEST_CASE("Model and reference agree with flow fpga_grip on random triangles", "[golden][fpga_grip]") {
    RandomStimulusOptions options;
    options.samples = {8, 8};
    check_traces(50000, 60, options, EdgeMapAlgorithm::dual_map, true, Flow::fpga_grip);
    options.window = {200, 200};
    options.width = {160, 640};
    options.height = {120, 480};
    options.samples = {3, 3};
    options.triangles = {0, 60};
    check_traces(50100, 3, options, EdgeMapAlgorithm::dual_map, true, Flow::fpga_grip);
}

TEST_CASE("Model and reference agree with flow fpga_grip on built-in classes", "[golden][fpga_grip]") {
    for (char const* const name : {"cracker_box", "banana", "tomato_soup_can", "mug", "scissors"}) {
        CAPTURE(name);
        AcceleratorConfig config = machine_of_seed(1);
        config.flow = Flow::fpga_grip;
        CHECK(check_model(config, posed_stimulus(models::make(name), 6, 510), Engine::decoupled) > 6 * 100);
    }
}

TEST_CASE("Model and reference agree on scanned meshes", "[golden]") {
    char const* const data = std::getenv("FASTER_SHARED_DATA");
    if (data == nullptr) {
        WARN("skipped: FASTER_SHARED_DATA (folder with meshes/) is not set");
        return;
    }
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(data) / "meshes"))
        if (files::has_mesh_extension(entry.path()))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    REQUIRE_FALSE(files.empty());
    for (std::size_t i = 0; i < files.size(); ++i) {
        CAPTURE(files[i].filename().string());
        Mesh mesh = files::load_mesh(files[i]);
        if (i % 4 != 0)  // every fourth as it was scanned
            mesh = workload::simplified(mesh, 1200);
        Stimulus const stimulus = posed_stimulus(std::move(mesh), 6, 300 + i);
        CHECK(check_model(machine_of_seed(i), stimulus, Engine::decoupled) > 0);
    }
}

}  // namespace faster::testing::model_vs_reference_test
