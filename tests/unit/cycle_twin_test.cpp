#include "support/cycle_twin.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/small_stimulus.hpp"

namespace faster::testing::cycle_twin_test {

TwinFifo const& fifo_of(TwinResult const& result, FifoId id) { return result.fifos.at(0)[index_of(id)]; }
TwinLoop const& loop_of(TwinResult const& result, LoopId id) { return result.loops.at(0)[index_of(id)]; }
TwinProcess const& process_of(TwinResult const& result, ModuleId id) { return result.processes.at(0)[index_of(id)]; }

TEST_CASE("The twin takes what the case by hand takes", "[cycle_twin]") {
    CHECK(run_twin(with_cores(1), empty_stimulus(200, 1)).total_cycles == 160015);
    CHECK(run_twin(with_cores(1), empty_stimulus(200, 2)).total_cycles == 160015 + 160010);
    CHECK(run_twin(with_cores(1), empty_stimulus(200, 3)).total_cycles == 160015 + 2 * 160010);
}

TEST_CASE("Without triangles a sample takes 4 W^2 + 15 cycles, and 4 W^2 + 10 each further one", "[cycle_twin]") {
    // EdgeMapBuilder: 1 + (W^2 - 1 + 2) to clear, end token, no iteration, 1 more: output starts at W^2 + 5, its first
    // write is at W^2 + 7, so the sweep (ready at W^2 + 4: 4 cycles early) starts at W^2 + 8. With II 3 it ends after
    // 3 (W^2 - 1) + 8 cycles, at 4 W^2 + 13, when the result is written; it is read one later, at 4 W^2 + 14.
    // The next sample's sweep starts 1 + (W^2 - 1 + 2) + 2 after the unit's last state, at 4 W^2 + 14.
    for (int const window : {4, 5, 12}) {
        Cycles const pixels = static_cast<Cycles>(window) * static_cast<Cycles>(window);
        for (int samples = 1; samples <= 4; ++samples) {
            CAPTURE(window, samples);
            Cycles const further = static_cast<Cycles>(samples - 1);
            TwinResult const result = run_twin(with_cores(1), empty_stimulus(window, samples));
            CHECK_FALSE(result.deadlock);
            CHECK(result.total_cycles == 4 * pixels + 15 + further * (4 * pixels + 10));
        }
    }
}

TEST_CASE("A window of 4 without triangles, cycle for cycle", "[cycle_twin]") {
    TwinResult const result = run_twin(with_cores(1), empty_stimulus(4, 1));
    // Header written at 0, read at 1 by all three. Sweep from 24 to 24 + 15 * 3 + 8 = 77: result written; read at 78.
    REQUIRE(result.samples.size() == 1);
    CHECK(result.samples[0].start_cycle == 1);
    CHECK(result.samples[0].end_cycle == 78);
    CHECK(result.total_cycles == 79);

    // The sweep reads pixel i (0..15) at 24 + 3 i. Pixel i's edge bit would be written at 23 + i; the FIFO holds 2, so
    // from i = 2 on not before 24 + 3 (i - 2) + 1 = 19 + 3 i: 23, 24, 25, 28, 31, ... 64. Each of i = 3..15 loses 2.
    TwinFifo const& edge_map = fifo_of(result, FifoId::edge_map);
    CHECK(edge_map.writes == 16);
    CHECK(edge_map.reads == 16);
    CHECK(edge_map.full_stall_cycles == 26);
    CHECK(edge_map.empty_stall_cycles == 4);  // sweep ready at 20
    CHECK(edge_map.max_occupancy == 2);       // after 25: three written, one read
    CHECK(process_of(result, ModuleId::edge_map_builder).end_cycle == 65);

    // Observed depth would be written from 6 on: 6, 7, then not before 24 + 3 (i - 2) + 1 = 19 + 3 i: 25 (17 late),
    // 28, ... 64, the 13 after i = 2 each 2 late. Both FIFOs are full; the first in program order is charged.
    CHECK(fifo_of(result, FifoId::observed_depth).full_stall_cycles == 17 + 26);
    CHECK(fifo_of(result, FifoId::observed_edge).full_stall_cycles == 0);
    CHECK(fifo_of(result, FifoId::observed_depth).empty_stall_cycles == 0);
    CHECK(process_of(result, ModuleId::observation_reader).full_stall == 43);

    // VertexTransform: header at 1, 1 cycle for the loop it does not enter.
    CHECK(process_of(result, ModuleId::vertex_transform).end_cycle == 3);
    // Rasterizer: header at 1, 1 cycle after the last of no triangles, End at 3.
    CHECK(process_of(result, ModuleId::rasterizer).end_cycle == 4);
    CHECK(process_of(result, ModuleId::sample_dispatcher).end_cycle == 1);
    CHECK(process_of(result, ModuleId::area_reciprocal).end_cycle == 0);
    CHECK(process_of(result, ModuleId::result_collector).empty_stall == 78);

    // 5 reads on 2 ports: 3 cycles an iteration, 2 of them lost.
    TwinLoop const& sweep = loop_of(result, LoopId::sweep);
    CHECK(sweep.ii == 3);
    CHECK(sweep.entries == 1);
    CHECK(sweep.iterations == 16);
    CHECK(sweep.port_conflict_cycles == 32);
    CHECK(sweep.recurrence_cycles == 0);
    CHECK(sweep.limited_by == "depth_buffer");
    CHECK(loop_of(result, LoopId::token).entries == 0);
    CHECK(loop_of(result, LoopId::token).limited_by.empty());

    // 2 x 2 inner pixels, all observed at 1 m; nothing drawn.
    CHECK(result.samples[0].counters == SampleCounters{0, 4, 0, 0, 0});
}

TEST_CASE("One small triangle, token by token", "[cycle_twin]") {
    // The scan's visits, in order, with what it sends:
    //   i0 (1,1) in   fragment, object     col_min: rightwards; prev_in is the start pixel's own, so no pending edge
    //   i1 (1,2) in   fragment, object
    //   i2 (1,3) out  edge                 right wall: next row, leftwards
    //   i3 (2,3) out  -                    a wall, but the line's start
    //   i4 (2,2) out  -
    //   i5 (2,1) in   fragment, object     left wall in the bottom row: ends, the pending edge (2,2) is lost
    // Vertices: header at 1, written at 2 + 40 + i = 42, 43, 44, read at 43, 44, 45. Setup 46..57.
    // Rasterizer: area and Triangle at 58; scan from 59, its 13 steps p at 59 + p while nothing stalls.
    //   p = 7, 8 (i0, i1) at 66, 67; p = 9 (i2, edge token only) at 68; p = 12 (i5) due at 71.
    // AreaReciprocal: area at 59, reciprocal readable from 59 + 36 + 1 = 96.
    // InlierUnit: cleared at 18, Triangle at 59; (reciprocal, Fragment i0) at 96, waiting 36 for the reciprocal.
    // Command: Triangle, i0 leave at 59, 96; i1 is the 3rd, i5 the 4th: it needs i0's place: 96 + 1 = 97, 26 late.
    // Fragment loop, step 0 at 97: depth i0, index i0, command i1.
    // Fragment depth: i5's is the 3rd, needs i0's place: 97 + 1 = 98, 1 more. So p = 12 at 98.
    // Fragment loop, step 1: depth i1, index i1, command i5, readable from 99: at 99, 1 late.
    // Rasterizer: 99, 100: (End, end token) at 100.
    // Fragment loop, step 2: depth i5, index i5, command End, readable from 101: at 101 instead of 100.
    //   10 - 1 steps more: ends at 111; End: 1; sweep from 112 to 112 + 53 = 165: result; read at 166.
    TwinResult const result = run_twin(with_cores(1), one_small_triangle());
    REQUIRE_FALSE(result.deadlock);
    CHECK(result.samples.at(0).start_cycle == 1);
    CHECK(result.samples.at(0).end_cycle == 166);
    CHECK(result.total_cycles == 167);

    TwinFifo const& command = fifo_of(result, FifoId::command);
    CHECK(command.writes == 5);
    CHECK(command.full_stall_cycles == 26);
    CHECK(command.empty_stall_cycles == (59 - 18) + 1 + 1);
    CHECK(command.max_occupancy == 2);
    CHECK(fifo_of(result, FifoId::fragment_depth).full_stall_cycles == 1);
    CHECK(fifo_of(result, FifoId::fragment_index).full_stall_cycles == 0);
    CHECK(fifo_of(result, FifoId::area_reciprocal).empty_stall_cycles == 36);
    CHECK(fifo_of(result, FifoId::area_reciprocal).max_occupancy == 1);
    CHECK(fifo_of(result, FifoId::area).empty_stall_cycles == 59);
    CHECK(fifo_of(result, FifoId::vertex).empty_stall_cycles == 43 - 2);
    CHECK(process_of(result, ModuleId::rasterizer).full_stall == 27);
    CHECK(process_of(result, ModuleId::rasterizer).end_cycle == 101);
    CHECK(process_of(result, ModuleId::area_reciprocal).end_cycle == 60);

    // Edge tokens O(1,1) O(1,2) E(1,3) O(2,1) end, written at 66, 67, 68, 98, 100. Token loop, one row a step:
    //   (18) waits 49 for O(1,1): 67      before the loop
    //    68  O(1,1), reads O(1,2)         69  its second iteration
    //    70  O(1,2), reads E(1,3)         71  its second iteration
    //    72  E(1,3), waits 27 for O(2,1), readable from 99: at 99
    //   100  O(2,1), waits 1 for the end token, readable from 101: at 101; its second iteration never runs
    // 6 iterations, 3 more steps: ends at 105; 1; output from 106: in time for the sweep at 112.
    TwinFifo const& edge_token = fifo_of(result, FifoId::edge_token);
    CHECK(edge_token.writes == 5);
    CHECK(edge_token.reads == 5);
    CHECK(edge_token.full_stall_cycles == 0);
    CHECK(edge_token.empty_stall_cycles == 49 + 27 + 1);
    CHECK(loop_of(result, LoopId::token).iterations == 6);
    CHECK(loop_of(result, LoopId::token).entries == 1);
    CHECK(loop_of(result, LoopId::scan).iterations == 6);
    CHECK(loop_of(result, LoopId::fragment).iterations == 3);

    // Edges: (0,1), (2,1) of O(1,1); (0,2), (2,2) of O(1,2); (1,3); then O(2,1) clears (2,1). Of the inner 2 x 2 pixels
    // (2,2) is left; the one above it is drawn. Everything drawn is at 1 m, as is all that is observed.
    CHECK(result.samples[0].counters == SampleCounters{3, 4, 4, 1, 1});
}

TEST_CASE("flush_last runs the second iteration that the end token cuts off", "[cycle_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.edge_map.flush_last = true;
    TwinResult const result = run_twin(config, one_small_triangle());
    // The 7th iteration starts at 102: the token loop ends at 106 instead of 105, still in time for the sweep.
    CHECK(loop_of(result, LoopId::token).iterations == 7);
    CHECK(result.total_cycles == 167);
}

TEST_CASE("fragment_depth of depth 1 deadlocks, as the command is read one ahead", "[cycle_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.fifo(FifoId::fragment_depth).depth = 1;
    TwinResult const result = run_twin(config, one_small_triangle());
    // The rasterizer holds fragment i1 (67) until i0's depth is read; the inlier unit reads it (97) together with the
    // command of i1. The edge map builder waits since 68, the observation reader since 8, the collector since 0.
    CHECK(result.deadlock);
    CHECK(result.deadlock_cycle == 97);
    CHECK(result.total_cycles == 0);

    config.fifo(FifoId::fragment_depth).kind = FifoKind::memory;  // capacity 2
    CHECK_FALSE(run_twin(config, one_small_triangle()).deadlock);
}

TEST_CASE("A reciprocal waits for its slot at issue, one for each stage and place", "[cycle_twin]") {
    // Two triangles between the pixels: codes (17,17), (17,20), (20,17); two scan iterations, (1,1) and (1,2), no
    // token.
    Stimulus stimulus = empty_stimulus(8, 1);
    constexpr std::uint16_t metre = 1U << 14;
    stimulus.triangles.assign(2, {{{17, 17, metre}, {17, 20, metre}, {20, 17, metre}}});
    stimulus.samples[0].triangle_count = 2;
    AcceleratorConfig config = with_cores(1);
    config.fifo(FifoId::area_reciprocal).depth = 1;
    config.fifo(FifoId::area_reciprocal).write_latency = 0;
    // Vertices written at 42..46, the 6th after the 4th is read (68): 69, 22 late.
    // Rasterizer: reads 43..45, setup, area and Triangle at 58; scan 59..67; reads 68, 69, 70; setup 71..82; area and
    // Triangle at 83; scan 84..92; 93; (End, end token) at 94.
    // InlierUnit: cleared at 1 + 65 = 66, Triangle at 66; (reciprocal, Triangle 83 + 1) at 84; no fragment: 86;
    // (reciprocal, End 94 + 1) at 95; no fragment: 97; End: 98.
    // AreaReciprocal: area at 59, issued at 59; area at 84, issue needs the only place, left at 84: 85, 1 late.
    // EdgeMapBuilder: end token at 95, 97, output from 98, first bit at 100: sweep from 101 to 101 + 63 * 3 + 8 = 298.
    TwinResult const result = run_twin(config, stimulus);
    CHECK(fifo_of(result, FifoId::vertex).full_stall_cycles == 22);
    CHECK(fifo_of(result, FifoId::area_reciprocal).full_stall_cycles == 1);
    CHECK(fifo_of(result, FifoId::area_reciprocal).empty_stall_cycles == 0);
    CHECK(fifo_of(result, FifoId::area_reciprocal).max_occupancy == 1);
    CHECK(fifo_of(result, FifoId::command).empty_stall_cycles == (84 - 67) + (95 - 86));
    CHECK(fifo_of(result, FifoId::edge_map).empty_stall_cycles == 3);
    CHECK(loop_of(result, LoopId::fragment).entries == 0);
    CHECK(loop_of(result, LoopId::scan).entries == 2);
    CHECK(loop_of(result, LoopId::scan).iterations == 4);
    CHECK(result.total_cycles == 300);

    // One pipeline stage is one more slot: no stall, but the second is readable from 84 + 1 + 1 = 86 all the same.
    config.fifo(FifoId::area_reciprocal).write_latency = 1;
    TwinResult const staged = run_twin(config, stimulus);
    CHECK(fifo_of(staged, FifoId::area_reciprocal).full_stall_cycles == 0);
    CHECK(staged.total_cycles == 300);
}

TEST_CASE("A memory FIFO is one deeper and one cycle slower", "[cycle_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.fifo(FifoId::result).depth = 3;
    config.fifo(FifoId::result).kind = FifoKind::memory;
    CHECK(run_twin(config, empty_stimulus(4, 1)).total_cycles == 80);
    config.fifo(FifoId::result).kind = FifoKind::shift_register;
    CHECK(run_twin(config, empty_stimulus(4, 1)).total_cycles == 79);
}

TEST_CASE("Loop figures follow target, recurrence and ports", "[cycle_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.memory(BramId::object_map).ports = 1;
    config.loop(LoopId::sweep).recurrence_ii = 4;
    config.loop(LoopId::sweep).ii = 2;
    config.loop(LoopId::fragment).recurrence_ii = 2;
    config.loop(LoopId::fragment).ii = 2;
    TwinResult const result = run_twin(config, one_small_triangle());
    CHECK(loop_of(result, LoopId::token).ii == 2);
    CHECK(loop_of(result, LoopId::token).limited_by == "object_map");
    CHECK(loop_of(result, LoopId::token).port_conflict_cycles == 6);
    CHECK(loop_of(result, LoopId::sweep).ii == 4);
    CHECK(loop_of(result, LoopId::sweep).limited_by == "recurrence");
    CHECK(loop_of(result, LoopId::sweep).port_conflict_cycles == 0);
    CHECK(loop_of(result, LoopId::sweep).recurrence_cycles == 32);
    CHECK(loop_of(result, LoopId::fragment).limited_by.empty());
    config.memory(BramId::edge_map).ports = 1;
    CHECK(loop_of(run_twin(config, one_small_triangle()), LoopId::token).limited_by == "edge_map");
}

TEST_CASE("Cores take consecutive samples and share nothing", "[cycle_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.cores = 4;
    TwinResult const result = run_twin(config, empty_stimulus(4, 5));  // 2, 2, 1 and none
    CHECK(result.total_cycles == 79 + 74);
    REQUIRE(result.fifos.size() == 4);
    CHECK(result.fifos[1][index_of(FifoId::result)].reads == 2);
    CHECK(result.fifos[2][index_of(FifoId::result)].reads == 1);
    CHECK(result.fifos[3][index_of(FifoId::result)].reads == 0);
    CHECK(result.processes[3][index_of(ModuleId::inlier_unit)].end_cycle == 0);
    CHECK(result.loops[3][index_of(LoopId::sweep)].limited_by == "depth_buffer");
    CHECK(result.samples.at(4).end_cycle == 78);
    CHECK(run_twin(config, empty_stimulus(4, 0)).total_cycles == 0);
}

TEST_CASE("The twin refuses what it cannot time", "[cycle_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.loop(LoopId::output).depth = 2;  // edge_map leaves in stage 2
    CHECK_THROWS_AS(run_twin(config, empty_stimulus(4, 1)), std::invalid_argument);
    Stimulus posed;
    posed.posed.poses.emplace_back();
    CHECK_THROWS_AS(run_twin(with_cores(1), posed), std::invalid_argument);
}

TEST_CASE("Every token of a random run is read, and deadlock-free configurations do not deadlock", "[cycle_twin]") {
    RandomStimulusOptions options;
    options.width = {24, 48};
    options.height = {24, 48};
    options.window = {8, 16};
    options.samples = {0, 4};
    options.triangles = {0, 8};
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        options.random_fraction_bits = seed % 2 == 1;
        Stimulus const stimulus = random_stimulus(seed, options);
        RandomConfigOptions few_cores;
        few_cores.cores = {1, 3};
        TwinResult const result = run_twin(random_config(seed, few_cores), stimulus);
        REQUIRE_FALSE(result.deadlock);
        for (auto const& core : result.fifos) {
            for (std::size_t i = 0; i < fifo_count; ++i) {
                CAPTURE(fifo_ids[i].name);
                CHECK(core[i].writes == core[i].reads);
            }
        }
    }
}

TEST_CASE("Timing never changes the counters", "[cycle_twin]") {
    RandomStimulusOptions options;
    options.width = {32, 32};
    options.height = {32, 32};
    options.samples = {3, 3};
    options.triangles = {6, 6};
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        Stimulus const stimulus = random_stimulus(seed, options);
        AcceleratorConfig config = random_config(seed);
        AcceleratorConfig defaults;
        defaults.edge_map.flush_last = config.edge_map.flush_last;
        TwinResult const slow = run_twin(config, stimulus);
        TwinResult const fast = run_twin(defaults, stimulus);
        REQUIRE(slow.samples.size() == fast.samples.size());
        for (std::size_t i = 0; i < slow.samples.size(); ++i) {
            CHECK(slow.samples[i].counters == fast.samples[i].counters);
        }
    }
}

TEST_CASE("Random stimuli and configurations are reproducible and differ between seeds", "[random_stimulus]") {
    Stimulus const a = random_stimulus(7);
    Stimulus const b = random_stimulus(7);
    CHECK(a.triangles == b.triangles);
    CHECK(a.observed_depth == b.observed_depth);
    CHECK_FALSE(a.observed_depth == random_stimulus(8).observed_depth);

    RandomStimulusOptions golden;
    golden.samples = {2, 2};
    golden.triangles = {5, 5};
    golden.kind = TriangleKind::Rejected;
    golden.share_triangles = false;
    Stimulus const fixed = random_stimulus(1, golden);
    REQUIRE(fixed.samples.size() == 2);
    REQUIRE(fixed.triangles.size() == 10);
    CHECK(fixed.triangles[0].vertex[0].x == rejected_vertex_code);
}

}  // namespace faster::testing::cycle_twin_test
