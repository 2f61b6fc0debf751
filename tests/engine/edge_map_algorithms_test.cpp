#include <catch2/catch.hpp>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/raster_machine.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::edge_map_algorithms_test {

AcceleratorConfig machine(EdgeMapAlgorithm algorithm) {
    AcceleratorConfig config = with_cores(1);
    config.edge_map.algorithm = algorithm;
    return config;
}

struct Schedule {
    Cycles ii;
    Cycles port_conflicts;  ///< per iteration
    Cycles recurrence;      ///< per iteration
    std::string limited_by;
};

void check_schedule(AcceleratorConfig const& config, LoopId loop, Schedule const& expected) {
    CAPTURE(static_cast<int>(config.edge_map.algorithm), std::string(loop));
    timing::InitiationInterval const interval = initiation_interval(loop, config);
    CHECK(interval.achieved == expected.ii);
    CHECK(interval.port_conflict_per_iteration == expected.port_conflicts);
    CHECK(interval.recurrence_per_iteration == expected.recurrence);
    CHECK(interval.limited_by == expected.limited_by);
}

LoopStatistics const& loop_of(RunStatistics const& run, LoopId id) { return run.cores.at(0).loops[index_of(id)]; }

TEST_CASE("Initiation intervals of the token loop, as derived in docs/timing-model.md", "[edge_map]") {
    using Algorithm = EdgeMapAlgorithm;
    // A read and a write of one map, two cycles apart.
    check_schedule(machine(Algorithm::threshold), LoopId::token, {2, 0, 1, "recurrence"});
    check_schedule(machine(Algorithm::transition), LoopId::token, {2, 0, 1, "recurrence"});
    // 1 write, 2 reads and 2 writes of one map: ceil(5 / 2) = 3, of which the recurrence asks for 2 anyway.
    check_schedule(machine(Algorithm::bounded), LoopId::token, {3, 1, 1, "edge_map"});
    check_schedule(machine(Algorithm::dual_map), LoopId::token, {1, 0, 0, ""});
    // 1 write and 2 reads of the object map: ceil(3 / 2) = 2.
    check_schedule(machine(Algorithm::dual_map_4_1_2), LoopId::token, {2, 1, 0, "object_map"});
    check_schedule(machine(Algorithm::inner_border), LoopId::token, {1, 0, 0, ""});
}

TEST_CASE("With other ports the token loops of the designs change as their accesses say", "[edge_map]") {
    AcceleratorConfig bounded = machine(EdgeMapAlgorithm::bounded);
    bounded.memory(BramId::edge_map).ports = 5;
    check_schedule(bounded, LoopId::token, {2, 0, 1, "recurrence"});
    bounded.memory(BramId::edge_map).ports = 1;
    check_schedule(bounded, LoopId::token, {5, 3, 1, "edge_map"});
    AcceleratorConfig first_write = machine(EdgeMapAlgorithm::dual_map_4_1_2);
    first_write.memory(BramId::object_map).ports = 3;
    check_schedule(first_write, LoopId::token, {1, 0, 0, ""});
    AcceleratorConfig inner = machine(EdgeMapAlgorithm::inner_border);
    for (BramId const bram : bram_ids)
        inner.memory(bram).ports = 1;
    for (LoopId const loop : {LoopId::edge_clear, LoopId::token, LoopId::output, LoopId::sweep})
        check_schedule(inner, loop, {1, 0, 0, ""});
}

TEST_CASE("A recurrence that is asked for counts if it is longer than the design's", "[edge_map]") {
    AcceleratorConfig config = machine(EdgeMapAlgorithm::transition);
    config.loop(LoopId::token).recurrence_ii = 3;
    check_schedule(config, LoopId::token, {3, 0, 2, "recurrence"});
}

TEST_CASE("The sweep reads five words per pixel, or one if contour pixels have a depth", "[edge_map]") {
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
          EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2})
        check_schedule(machine(algorithm), LoopId::sweep, {3, 2, 0, "depth_buffer"});
    check_schedule(machine(EdgeMapAlgorithm::inner_border), LoopId::sweep, {1, 0, 0, ""});
}

TEST_CASE("Without triangles inner_border takes 2 W^2 + W + 17 cycles", "[edge_map]") {
    // Clearing ends at T = W^2 + 2, the builder turns to its output at W^2 + 5, its first bit leaves W + 2 steps later,
    // the sweep takes it at W^2 + W + 8 and a bit per cycle from then on. Its last step is W^2 + 7 cycles later; the
    // result leaves, and is read, in the two after that. The next sample follows when the builder has sent its last
    // bit: its output loop of W^2 + W iterations ends at 2 W^2 + W + 7.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    AcceleratorConfig const config = machine(EdgeMapAlgorithm::inner_border);
    for (int const window : {8, 33, 200}) {
        auto const side = static_cast<Cycles>(window);
        Cycles const first = 2 * side * side + side + 17;
        Cycles const next = 2 * side * side + side + 7;
        for (int const samples : {1, 2, 3}) {
            CAPTURE(engine, window, samples);
            RunStatistics const run = test_run(config, empty_stimulus(window, samples), engine).statistics;
            CHECK(run.total_cycles == first + static_cast<Cycles>(samples - 1) * next);
            CHECK(loop_of(run, LoopId::sweep).ii == 1);
            CHECK(loop_of(run, LoopId::sweep).port_conflict_cycles == 0);
            CHECK(loop_of(run, LoopId::output).iterations == static_cast<Cycles>(samples) * (side * side + side));
        }
    }
}

TEST_CASE("Each token costs bounded a cycle of port conflict, and more than the two maps", "[edge_map]") {
    // The tokens of the triangle are O(1,1), E(1,2), O(2,1) and those of its other pixel: 5 in all, 3 of them objects.
    auto const token_loop = [](EdgeMapAlgorithm algorithm) {
        return loop_of(test_run(machine(algorithm), one_small_triangle(), Engine::lockstep).statistics, LoopId::token);
    };
    LoopStatistics const dual = token_loop(EdgeMapAlgorithm::dual_map);
    LoopStatistics const bounded = token_loop(EdgeMapAlgorithm::bounded);
    LoopStatistics const first_write = token_loop(EdgeMapAlgorithm::dual_map_4_1_2);
    std::uint64_t const tokens = bounded.iterations;
    CHECK(bounded.port_conflict_cycles == tokens);
    CHECK(bounded.recurrence_cycles == tokens);
    CHECK(bounded.limited_by == "edge_map");
    CHECK(dual.iterations > tokens);                                     // second iterations ...
    CHECK(dual.iterations * dual.ii < bounded.iterations * bounded.ii);  // ... and yet fewer cycles
    CHECK(first_write.port_conflict_cycles == first_write.iterations);
    CHECK(first_write.iterations * first_write.ii > dual.iterations * dual.ii);
}

}  // namespace faster::testing::edge_map_algorithms_test
