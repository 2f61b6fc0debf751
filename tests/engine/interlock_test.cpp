#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <string>

#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "faster/dataflow_names.hpp"
#include "support/engine_agreement.hpp"
#include "support/parts.hpp"
#include "support/random_memory.hpp"
#include "support/random_stimulus.hpp"
#include "support/small_stimulus.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing::interlock_test {

char const* const depth_buffer = "inlier_unit.fragment.depth_buffer";
char const* const object_map = "edge_map_builder.token.object_map";
char const* const edge_map = "edge_map_builder.token.edge_map";

/// Triangles of one pixel each, all of the same, nearer and nearer: in one loop over all of them, its fragments are
/// the second, fourth, sixth, ... iteration.
Stimulus same_pixel(int triangles) {
    Stimulus stimulus = empty_stimulus(8, 1);
    for (int i = 0; i < triangles; ++i) {
        auto const z = static_cast<std::uint16_t>((1 << 14) - 64 * i);
        stimulus.triangles.push_back({{{16, 16, z}, {16, 24, z}, {24, 16, z}}});
    }
    stimulus.samples[0].triangle_count = static_cast<std::uint32_t>(triangles);
    return stimulus;
}

AcceleratorConfig flattened() {
    AcceleratorConfig config = with_cores(1);
    config.inlier_unit.fragment_loop = FragmentLoop::flattened;
    config.dependence(depth_buffer).hazards = HazardHandling::interlock;
    return config;
}

/// Of the fragment loop, in a run on which both engines and the twin agree.
Cycles waited(AcceleratorConfig const& config, Stimulus const& stimulus) {
    CHECK(check_agreement(config, stimulus));
    RunStatistics const run = test_run(config, stimulus, Engine::decoupled).statistics;
    return run.cores.at(0).loops.at(index_of(LoopId::fragment)).interlock_cycles;
}

TEST_CASE("An iteration waits until what it reads has been written", "[interlock]") {
    // From stage 7 to 9: an iteration may begin 3 steps after one that writes its word, and would begin 2 after it.
    AcceleratorConfig config = flattened();
    CHECK(waited(config, same_pixel(1)) == 0);
    CHECK(waited(config, same_pixel(2)) == 1);
    CHECK(waited(config, same_pixel(5)) == 4);
    config.dependence(depth_buffer).read_stage = 0;  // 10 steps
    CHECK(waited(config, same_pixel(2)) == 8);
    CHECK(waited(config, same_pixel(5)) == 4 * 8);
    config.loop(LoopId::fragment).ii = 4;  // 2 x 4 steps apart by themselves
    CHECK(waited(config, same_pixel(5)) == 4 * 2);
    config.loop(LoopId::fragment).ii = 5;
    CHECK(waited(config, same_pixel(5)) == 0);
    config.loop(LoopId::fragment).ii = 1;
    config.loop(LoopId::fragment).depth = 6;  // the stages move: 0 to 5
    CHECK(waited(config, same_pixel(5)) == 4 * 4);
    config.dependence(depth_buffer).hazards = HazardHandling::forward;
    CHECK(waited(config, same_pixel(5)) == 0);
}

TEST_CASE("Steps in which another iteration waited count", "[interlock]") {
    // Fragments of pixels a, b, a, b are the iterations 1, 3, 5 and 7. With 8 steps from a read to the begin of the
    // next, the second a waits 8 - 4, and the second b, which 4 steps and those 4 are behind the first, not at all.
    Stimulus stimulus = same_pixel(4);
    for (std::size_t const i : {1U, 3U})
        for (auto& vertex : stimulus.triangles[i].vertex)
            vertex.x = static_cast<std::int16_t>(vertex.x + 16);
    AcceleratorConfig config = flattened();
    config.dependence(depth_buffer).read_stage = 2;
    CHECK(waited(config, stimulus) == 4);
}

TEST_CASE("Waiting for writes is recurrence: of the loop, of its module, on the critical path", "[interlock]") {
    AcceleratorConfig config = flattened();
    config.loop(LoopId::fragment).depth = 300;  // so that nothing else takes as long
    config.dependence(depth_buffer).read_stage = 0;
    config.dependence(depth_buffer).write_stage = 249;
    Cycles const expected = 9 * (250 - 2);
    CHECK(waited(config, same_pixel(10)) == expected);
    TestRunOptions options;
    options.critical_path = true;
    RunStatistics const run = test_run(config, same_pixel(10), Engine::decoupled, options).statistics;
    CHECK(run.cores.at(0).loops.at(index_of(LoopId::fragment)).recurrence_cycles == expected);
    CHECK(run.cores.at(0).processes.at(index_of(ModuleId::inlier_unit))[CycleClass::recurrence] == expected);
    REQUIRE(run.critical_path.has_value());
    Cycles on_path = 0, all = 0;
    for (PathRow const& row : run.critical_path->rows) {
        on_path += row.cause == PathCause::recurrence ? row.cycles : 0;
        all += row.cycles;
    }
    CHECK(on_path == expected);
    CHECK(all == run.total_cycles);
}

/// Any stages, some beyond the end of the pipeline.
void draw_interlocks(std::uint64_t seed, AcceleratorConfig& config) {
    std::mt19937_64 random(~seed);
    for (char const* const name : {depth_buffer, object_map, edge_map}) {
        DependenceSettings& dependence = config.dependence(name);
        dependence.hazards = random() % 4 == 0 ? HazardHandling::report : HazardHandling::interlock;
        dependence.write_stage = random() % (seed % 4 == 1 ? 14 : 24);
        dependence.read_stage = random() % (*dependence.write_stage + 1);
    }
}

struct Trial {
    Stimulus stimulus;
    AcceleratorConfig config;
};

/// Small triangles, most of them twice in a row. Every third machine has an external memory.
Trial trial(std::uint64_t seed) {
    RandomConfigOptions machine;
    machine.cores = {1, 4};
    machine.algorithm = static_cast<EdgeMapAlgorithm>(seed % 6);
    machine.max_target_ii = machine.max_recurrence_ii = seed % 2 == 0 ? 1 : 4;
    machine.any_scan = machine.any_clearing = machine.any_buffers = machine.any_region = machine.any_partition = true;
    machine.max_scan_lanes = seed % 6 == 5 ? 5 : 1;  // inner_border
    machine.is_deadlock_free = seed % 5 != 0;
    RandomStimulusOptions work;
    work.width = work.height = {12, 20};
    work.window = {4, 12};
    work.samples = {1, 6};
    work.triangles = {8, 40};
    work.kind = seed % 2 == 0 ? TriangleKind::Small : TriangleKind::Tiny;
    Trial trial{random_stimulus(seed, work), random_config(seed, machine)};
    for (std::size_t i = 1; i < trial.stimulus.triangles.size(); ++i)
        if (i % 4 != 0)
            trial.stimulus.triangles[i] = trial.stimulus.triangles[i - 1];
    for (LoopId const loop : {LoopId::token, LoopId::fragment})
        if (seed % 4 != 1)
            trial.config.loop(loop).depth = 24;
    draw_interlocks(seed, trial.config);
    if (seed % 3 == 1)
        draw_memory(seed, trial.config);
    adopt(trial.stimulus, trial.config);
    return trial;
}

/// Of all cores and loops.
Cycles all_waited(RunStatistics const& run) {
    Cycles sum = 0;
    for (CoreStatistics const& core : run.cores)
        for (LoopStatistics const& loop : core.loops)
            sum += loop.interlock_cycles;
    return sum;
}

TEST_CASE("Engines and twin agree on iterations that wait, seeds 35000 to 35119", "[interlock]") {
    int deadlocks = 0, waiting = 0;
    for (std::uint64_t seed = 35000; seed < 35120; ++seed) {
        CAPTURE(seed);
        Trial const one = trial(seed);
        deadlocks += check_agreement(one.config, one.stimulus) ? 0 : 1;
        waiting += all_waited(test_run(one.config, one.stimulus, Engine::decoupled).statistics) > 0 ? 1 : 0;
    }
    CHECK(waiting > 30);
    CHECK(deadlocks > 2);
    CHECK(deadlocks < 40);
}

/// What a recording allows: not the stages, nor who waits.
AcceleratorConfig other_timing(std::uint64_t seed, AcceleratorConfig config) {
    std::mt19937_64 random(seed);
    RandomConfigOptions machine;
    machine.cores = {1, 5};
    machine.is_deadlock_free = seed % 4 != 0;
    AcceleratorConfig const drawn = random_config(seed + 100'000, machine);
    config.cores = drawn.cores;
    config.fifos = drawn.fifos;
    config.loops = drawn.loops;
    for (auto& [name, memory] : config.memories)
        memory.ports = 1 + random() % 4;
    return config;
}

TEST_CASE("A recording knows who waits for whom with any other interval, depth or core", "[interlock][events]") {
    test::TempFolder const folder;
    int recorded = 0, others_waiting = 0;
    for (std::uint64_t seed = 36000; seed < 36060; ++seed) {
        CAPTURE(seed);
        Trial const one = trial(seed);
        TestRunOptions fork;
        fork.events = folder / "events";
        if (test_run(one.config, one.stimulus, seed % 2 == 0 ? Engine::decoupled : Engine::lockstep, fork)
                .statistics.deadlocked())
            continue;
        ++recorded;
        events::EventFile const file = events::read_event_file(fork.events);
        AcceleratorConfig const other = other_timing(seed, one.config);
        check_retiming(file.run, one.config, one.stimulus);
        others_waiting += all_waited(check_retiming(file.run, other, one.stimulus)) > 0 ? 1 : 0;
    }
    CHECK(recorded > 40);
    CHECK(others_waiting > 7);
}

TEST_CASE("Waiting changes neither distances nor maps", "[interlock]") {
    int waiting = 0, compared = 0;
    for (std::uint64_t seed = 37000; seed < 37024; ++seed) {
        CAPTURE(seed);
        Trial one = trial(seed);
        TestRunOptions options;
        options.with_maps = options.hazards = true;
        TestRun const waiting_run = test_run(one.config, one.stimulus, Engine::decoupled, options);
        for (char const* const name : {depth_buffer, object_map, edge_map})
            one.config.dependence(name).hazards = HazardHandling::report;
        TestRun const stale = test_run(one.config, one.stimulus, Engine::decoupled, options);
        std::vector<DependenceRow> const rows = dependence_rows(waiting_run.statistics);
        std::vector<DependenceRow> const others = dependence_rows(stale.statistics);
        REQUIRE(rows.size() == others.size());
        waiting += all_waited(waiting_run.statistics) > 0 ? 1 : 0;
        CHECK(all_waited(stale.statistics) == 0);
        for (std::size_t i = 0; i < rows.size(); ++i)
            CHECK(rows[i].counts == others[i].counts);
        if (waiting_run.statistics.deadlocked() || stale.statistics.deadlocked())
            continue;
        for (std::size_t i = 0; i < stale.maps.size(); ++i) {
            CHECK(waiting_run.maps[i].edge_map == stale.maps[i].edge_map);
            CHECK(waiting_run.maps[i].depth_buffer == stale.maps[i].depth_buffer);
            ++compared;
        }
    }
    CHECK(waiting > 6);
    CHECK(compared > 20);
}

}  // namespace faster::testing::interlock_test
