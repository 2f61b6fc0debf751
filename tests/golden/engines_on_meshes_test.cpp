#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "faster/dataflow_names.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "support/random_stimulus.hpp"
#include "support/run_cells.hpp"
#include "support/test_run.hpp"

namespace faster::testing::engines_on_meshes_test {

/// A few samples of a built-in object in its scene, at the scale of the main job.
Stimulus scene_of(std::string const& object, std::uint64_t samples) {
    WorkloadConfig workload;
    workload.target.object = object;
    workload.target.rotation_deg = {20, 30, -70};  // every side of it
    workload.samples.count = samples;
    AcceleratorConfig const machine;
    return workload::build_stimulus(workload, machine.window, machine.fraction_bits);
}

void check_engines(AcceleratorConfig const& config, Stimulus const& stimulus) {
    RunStatistics const decoupled = test_run(config, stimulus, Engine::decoupled).statistics;
    RunStatistics const lockstep = test_run(config, stimulus, Engine::lockstep).statistics;
    REQUIRE_FALSE(lockstep.deadlocked());
    CHECK(first_difference(all_cells(decoupled), all_cells(lockstep)) == "");
}

TEST_CASE("Engines agree on meshes under the default machine", "[engines_on_meshes]") {
    AcceleratorConfig config;
    config.cores = 2;
    for (char const* object : {"cracker_box", "banana", "mug"}) {
        CAPTURE(object);
        check_engines(config, scene_of(object, 5));
    }
}

TEST_CASE("Engines agree on meshes with every edge map algorithm", "[engines_on_meshes][edge_map]") {
    Stimulus const scene = scene_of("tomato_soup_can", 3);
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
          EdgeMapAlgorithm::dual_map_4_1_2, EdgeMapAlgorithm::inner_border}) {
        CAPTURE(static_cast<int>(algorithm));
        AcceleratorConfig config;
        config.cores = 2;
        config.edge_map.algorithm = algorithm;
        check_engines(config, scene);
    }
}

TEST_CASE("Engines agree on meshes under random machines", "[engines_on_meshes]") {
    std::array<Stimulus, 3> const scenes{scene_of("potted_meat_can", 3), scene_of("scissors", 3),
                                         scene_of("power_drill", 3)};
    for (std::uint64_t seed = 9000; seed < 9024; ++seed) {
        CAPTURE(seed);
        RandomConfigOptions options;
        options.cores = {1, 2};
        options.fifo_depth = {2, seed % 2 == 0 ? 4 : 64};
        check_engines(random_config(seed, options), scenes[seed % scenes.size()]);
    }
}

}  // namespace faster::testing::engines_on_meshes_test
