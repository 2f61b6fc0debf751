#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/cycle_twin.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::closed_form_test {

Engine either_engine() { return GENERATE(Engine::lockstep, Engine::decoupled); }

FifoStatistics const& fifo_of(RunStatistics const& run, FifoId id) { return run.cores.at(0).fifos[index_of(id)]; }
LoopStatistics const& loop_of(RunStatistics const& run, LoopId id) { return run.cores.at(0).loops[index_of(id)]; }
ProcessStatistics const& process_of(RunStatistics const& run, ModuleId id) {
    return run.cores.at(0).processes[index_of(id)];
}

TEST_CASE("The engines take what the case by hand takes", "[closed_form]") {
    Engine const engine = either_engine();
    for (int const samples : {1, 2, 3}) {
        CAPTURE(engine, samples);
        RunStatistics const run = test_run(with_cores(1), empty_stimulus(200, samples), engine).statistics;
        CHECK(run.total_cycles == 160015 + static_cast<Cycles>(samples - 1) * 160010);
    }
}

TEST_CASE("Without triangles an engine takes 4 W^2 + 15 cycles and 4 W^2 + 10 each further sample", "[closed_form]") {
    Engine const engine = either_engine();
    for (int const window : {4, 5, 12, 33}) {
        Cycles const pixels = static_cast<Cycles>(window) * static_cast<Cycles>(window);
        for (int samples = 1; samples <= 4; ++samples) {
            CAPTURE(engine, window, samples);
            RunStatistics const run = test_run(with_cores(1), empty_stimulus(window, samples), engine).statistics;
            CHECK_FALSE(run.deadlocked());
            CHECK(run.total_cycles == 4 * pixels + 15 + static_cast<Cycles>(samples - 1) * (4 * pixels + 10));
        }
    }
}

TEST_CASE("One small triangle, as worked out by hand", "[closed_form]") {
    // The cycles are derived in the unit test of the cycle twin.
    Engine const engine = either_engine();
    CAPTURE(engine);
    RunStatistics const run = test_run(with_cores(1), one_small_triangle(), engine).statistics;
    REQUIRE_FALSE(run.deadlocked());
    CHECK(run.total_cycles == 167);
    REQUIRE(run.samples.size() == 1);
    CHECK(run.samples[0].start_cycle == 1);
    CHECK(run.samples[0].end_cycle == 166);
    CHECK(run.samples[0].latency_cycles() == 166);
    CHECK(run.samples[0].counters == Counters{3, 4, 4, 1, 1});

    FifoStatistics const& command = fifo_of(run, FifoId::command);
    CHECK(command.writes == 5);
    CHECK(command.reads == 5);
    CHECK(command.full_stall_cycles == 26);
    CHECK(command.empty_stall_cycles == (59 - 18) + 1 + 1);
    CHECK(command.max_occupancy == 2);
    CHECK(fifo_of(run, FifoId::fragment_depth).full_stall_cycles == 1);
    CHECK(fifo_of(run, FifoId::fragment_index).full_stall_cycles == 0);
    CHECK(fifo_of(run, FifoId::area_reciprocal).empty_stall_cycles == 36);
    CHECK(fifo_of(run, FifoId::area).empty_stall_cycles == 59);
    CHECK(fifo_of(run, FifoId::vertex).empty_stall_cycles == 43 - 2);
    CHECK(fifo_of(run, FifoId::edge_token).empty_stall_cycles == 49 + 27 + 1);
    CHECK(loop_of(run, LoopId::token).iterations == 6);
    CHECK(loop_of(run, LoopId::scan).iterations == 6);
    CHECK(loop_of(run, LoopId::fragment).iterations == 3);
    CHECK(loop_of(run, LoopId::sweep).ii == 3);
    CHECK(loop_of(run, LoopId::sweep).port_conflict_cycles == 32);

    ProcessStatistics const& rasterizer = process_of(run, ModuleId::rasterizer);
    CHECK(rasterizer[CycleClass::idle_before] == 1);  // the header
    CHECK(rasterizer[CycleClass::empty_stall] == 41);
    CHECK(rasterizer.stalls[index_of(FifoId::vertex)] == 41);  // the first vertex
    CHECK(rasterizer[CycleClass::full_stall] == 27);
    CHECK(rasterizer.stalls[index_of(FifoId::command)] == 26);
    CHECK(rasterizer.stalls[index_of(FifoId::fragment_depth)] == 1);
    CHECK(rasterizer[CycleClass::setup] == 12);
    CHECK(rasterizer[CycleClass::fill_drain] == 8 - 1);
    CHECK(rasterizer[CycleClass::busy] == 1 + 3 + 1 + 6 + 1 + 1);  // header, vertices, area, scan, before and after end
    CHECK(rasterizer[CycleClass::idle_after] == 167 - 101);
    ProcessStatistics const& reciprocal = process_of(run, ModuleId::area_reciprocal);
    CHECK(reciprocal[CycleClass::idle_before] == 59);
    CHECK(reciprocal[CycleClass::empty_stall] == 0);
    ProcessStatistics const& inlier = process_of(run, ModuleId::inlier_unit);
    CHECK(inlier[CycleClass::port_conflict] == 32);
    CHECK(inlier.port_conflicts[index_of(BramId::depth_buffer)] == 32);
    CHECK(inlier[CycleClass::idle_before] == 0);  // it clears first
}

TEST_CASE("A run without samples takes no cycle", "[closed_form]") {
    Engine const engine = either_engine();
    CAPTURE(engine);
    RunStatistics const run = test_run(with_cores(3), empty_stimulus(4, 0), engine).statistics;
    CHECK(run.total_cycles == 0);
    CHECK(run.samples.empty());
    CHECK_FALSE(run.deadlocked());
    CHECK(run.cores.size() == 3);
}

TEST_CASE("Cores take consecutive samples, one without samples has rows of zeros", "[closed_form]") {
    Engine const engine = either_engine();
    CAPTURE(engine);
    RunStatistics const run = test_run(with_cores(4), empty_stimulus(4, 5), engine).statistics;  // 2, 2, 1 and none
    CHECK(run.total_cycles == 79 + 74);
    REQUIRE(run.samples.size() == 5);
    std::vector<std::uint64_t> cores;
    for (SampleStatistics const& sample : run.samples)
        cores.push_back(sample.core);
    CHECK(cores == std::vector<std::uint64_t>{0, 0, 1, 1, 2});
    CHECK(run.samples[4].end_cycle == 78);

    REQUIRE(run.cores.size() == 4);
    CHECK(run.cores[2].end_cycle == 79);
    CoreStatistics const& idle = run.cores[3];
    CHECK(idle.samples == 0);
    CHECK(idle.end_cycle == 0);
    for (FifoStatistics const& fifo : idle.fifos) {
        CHECK(fifo.writes + fifo.reads + fifo.full_stall_cycles + fifo.empty_stall_cycles + fifo.max_occupancy == 0);
        CHECK(fifo.depth == 2);
    }
    for (LoopStatistics const& loop : idle.loops)
        CHECK(loop.entries + loop.iterations + loop.port_conflict_cycles + loop.recurrence_cycles == 0);
    CHECK(idle.loops[index_of(LoopId::sweep)].limited_by == "depth_buffer");  // static
    for (ProcessStatistics const& process : idle.processes) {
        CHECK(process[CycleClass::idle_after] == run.total_cycles);
        CHECK(process.sum() == run.total_cycles);
    }
}

TEST_CASE("A fragment FIFO of depth 1 deadlocks in a circle", "[closed_form]") {
    Engine const engine = either_engine();
    FifoId const fifo = GENERATE(FifoId::fragment_depth, FifoId::fragment_index);
    CAPTURE(engine, name_of(fifo));
    AcceleratorConfig config = with_cores(1);
    config.fifo(fifo).depth = 1;
    TwinResult const twin = run_twin(config, one_small_triangle());
    RunStatistics const run = test_run(config, one_small_triangle(), engine).statistics;
    REQUIRE(twin.deadlock);
    REQUIRE(run.deadlocked());
    CHECK(run.deadlock_cycle() == twin.deadlock_cycle);
    CHECK(run.deadlock_cycle() == 97);
    CHECK(run.samples.empty());

    std::vector<StuckProcess> const circle = run.wait_cycle();
    REQUIRE(circle.size() == 2);
    for (std::size_t i = 0; i < circle.size(); ++i) {
        StuckProcess const& process = circle[i];
        CHECK(process.waits_for == circle[(i + 1) % circle.size()].process);
        CHECK(process.to_write == (process.process == std::string("rasterizer")));
        CHECK(process.occupancy == (process.to_write ? process.capacity : 0));
    }
}

TEST_CASE("A command FIFO of depth 1 alone is slow but goes on", "[closed_form]") {
    // The fragment's other tokens wait in FIFOs of depth 2 while its command is read one ahead.
    Engine const engine = either_engine();
    CAPTURE(engine);
    Stimulus stimulus = empty_stimulus(16, 2);
    constexpr std::uint16_t metre = 1U << 14;
    stimulus.triangles.push_back({{{16, 16, metre}, {16, 192, metre}, {192, 16, metre}}});
    for (SampleInput& sample : stimulus.samples)
        sample.triangle_count = 1;
    AcceleratorConfig config = with_cores(1);
    Cycles const of_depth_2 = test_run(config, stimulus, engine).statistics.total_cycles;
    config.fifo(FifoId::command).depth = 1;
    TwinResult const twin = run_twin(config, stimulus);
    RunStatistics const run = test_run(config, stimulus, engine).statistics;
    REQUIRE_FALSE(twin.deadlock);
    REQUIRE_FALSE(run.deadlocked());
    CHECK(run.total_cycles == twin.total_cycles);
    CHECK(run.total_cycles > of_depth_2);

    config.fifo(FifoId::fragment_depth).depth = 1;  // all three are shallow
    config.fifo(FifoId::fragment_index).depth = 1;
    TwinResult const stuck_twin = run_twin(config, stimulus);
    RunStatistics const stuck = test_run(config, stimulus, engine).statistics;
    REQUIRE(stuck_twin.deadlock);
    REQUIRE(stuck.deadlocked());
    CHECK(stuck.deadlock_cycle() == stuck_twin.deadlock_cycle);
    CHECK_FALSE(stuck.wait_cycle().empty());
}

}  // namespace faster::testing::closed_form_test
