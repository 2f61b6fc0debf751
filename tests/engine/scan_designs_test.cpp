#include <algorithm>
#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::scan_designs_test {

LoopStatistics const& loop_of(RunStatistics const& run, LoopId id) { return run.cores.at(0).loops[index_of(id)]; }

Cycles setup_cycles_of(RunStatistics const& run) {
    return run.cores.at(0).processes[index_of(ModuleId::rasterizer)][CycleClass::setup];
}

/// One sample of back faces only: each triangle is three iterations where one loop takes all.
Stimulus back_faces(std::uint32_t count) {
    Stimulus stimulus = one_small_triangle();
    TriangleCode face = stimulus.triangles[0];
    std::swap(face.vertex[1], face.vertex[2]);
    stimulus.triangles.assign(count, face);
    stimulus.samples[0].triangle_count = count;
    return stimulus;
}

TEST_CASE("Setups are waited for unless enough triangles are fetched ahead", "[scan_designs]") {
    // A setup takes 12 cycles and begins when its third vertex has been read. So N back faces, three iterations each,
    // come every max(3 N, 3 + 12) cycles: five ahead are enough. The first begins 12 cycles after its vertices; the
    // vertices of the other N - 1 are read meanwhile.
    constexpr Cycles faces = 20;
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (Cycles ahead = 1; ahead <= 8; ++ahead) {
        CAPTURE(engine, ahead);
        AcceleratorConfig config = with_cores(1);
        config.rasterizer.setup_overlap = ahead;
        RunStatistics const run = test_run(config, back_faces(faces), engine).statistics;
        Cycles const first_wait = ahead >= 5 ? 0 : 15 - 3 * ahead;
        Cycles const rounds = (faces - 1) / ahead;
        CHECK(setup_cycles_of(run) == first_wait * (1 + rounds));
        CHECK(loop_of(run, LoopId::scan).entries == 1);
        CHECK(loop_of(run, LoopId::scan).iterations == 3 * ahead + 3 * faces);
    }
}

TEST_CASE("Without overlap every triangle's setup is waited for, and spans divide", "[scan_designs]") {
    AcceleratorConfig config = with_cores(1);
    CHECK(setup_cycles_of(test_run(config, back_faces(20), Engine::decoupled).statistics) == 20 * 12);
    config.rasterizer.scan = ScanPolicy::spans;
    CHECK(setup_cycles_of(test_run(config, back_faces(20), Engine::decoupled).statistics) == 20 * (12 + 18));
}

TEST_CASE("The loops of a small triangle", "[scan_designs]") {
    // Covered: (1,1), (1,2), then (2,1). Zigzag: both, the edge (1,3), back over (2,3) and (2,2) to (2,1). An early
    // exit cannot turn before (1,3), a wall. Spans leave out (2,3) and (2,2), which send nothing.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    CAPTURE(engine);
    auto const iterations = [engine](AcceleratorConfig const& config, LoopId loop) {
        return loop_of(test_run(config, one_small_triangle(), engine).statistics, loop).iterations;
    };
    AcceleratorConfig config = with_cores(1);
    CHECK(iterations(config, LoopId::scan) == 6);
    CHECK(iterations(config, LoopId::fragment) == 3);
    config.rasterizer.scan = ScanPolicy::early_exit;
    CHECK(iterations(config, LoopId::scan) == 6);
    config.rasterizer.scan = ScanPolicy::spans;
    CHECK(iterations(config, LoopId::scan) == 4);
    config.rasterizer.setup_overlap = 2;  // three to read the vertices, one to announce the triangle
    CHECK(iterations(config, LoopId::scan) == 3 + 1 + 4);
    config.inlier_unit.fragment_loop = FragmentLoop::flattened;  // one more has the command Triangle
    CHECK(iterations(config, LoopId::fragment) == 4);
}

TEST_CASE("The loops of a small triangle with lanes", "[scan_designs][lanes]") {
    // Row 1 from column 1 to the wall at 3, of which 1 and 2 are covered; row 2 back to column 1, the only one.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    AcceleratorConfig config = with_cores(1);
    config.edge_map.algorithm = EdgeMapAlgorithm::inner_border;
    config.rasterizer.edge_tokens = EdgeTokens::object;
    auto const loops = [&](int lanes) {
        config.rasterizer.lanes = lanes;
        return test_run(config, one_small_triangle(), engine).statistics;
    };
    RunStatistics const two = loops(2);  // 1 | 2, 3 and back
    CHECK(loop_of(two, LoopId::scan).iterations == 4);
    CHECK(loop_of(two, LoopId::fragment).iterations == 3);
    CHECK(loop_of(two, LoopId::token).iterations == 3);
    CHECK(loop_of(two, LoopId::fragment).ii == 2);  // two reads and two writes, two ports
    CHECK(loop_of(two, LoopId::token).ii == 1);
    RunStatistics const four = loops(4);  // a group per row
    CHECK(loop_of(four, LoopId::scan).iterations == 2);
    CHECK(loop_of(four, LoopId::fragment).iterations == 2);
    CHECK(loop_of(four, LoopId::fragment).ii == 4);
    CHECK(loop_of(four, LoopId::token).ii == 2);
    config.rasterizer.scan = ScanPolicy::spans;  // not 3 and 2 on the way back
    CHECK(loop_of(loops(2), LoopId::scan).iterations == 3);
    for (BramId const bram : {BramId::object_map, BramId::depth_buffer})
        config.memory(bram).partition = {PartitionType::cyclic, 4, 2};
    RunStatistics const banked = loops(4);
    CHECK(loop_of(banked, LoopId::fragment).ii == 1);
    CHECK(loop_of(banked, LoopId::token).ii == 1);
    CHECK(banked.samples.at(0).counters == two.samples.at(0).counters);
}

TEST_CASE("One loop over all fragments saves draining it for each triangle", "[scan_designs]") {
    AcceleratorConfig config = with_cores(1);
    config.rasterizer.setup_overlap = 5;
    for (FifoId const fifo : {FifoId::command, FifoId::fragment_depth, FifoId::fragment_index, FifoId::edge_token})
        config.fifo(fifo).depth = 64;
    Stimulus stimulus = one_small_triangle();
    stimulus.triangles.assign(100, stimulus.triangles[0]);
    stimulus.samples[0].triangle_count = 100;
    Cycles const drained = test_run(config, stimulus, Engine::decoupled).statistics.total_cycles;
    config.inlier_unit.fragment_loop = FragmentLoop::flattened;
    Cycles const flattened = test_run(config, stimulus, Engine::decoupled).statistics.total_cycles;
    // Per triangle: a step of its own and three fragments with nine stages behind them, against four iterations. From
    // then on the scan sets the pace: an iteration to announce the triangle, and six.
    CHECK(drained - flattened > 99 * (1 + 2 + 10 - 7) - 40);
    CHECK(drained - flattened < 99 * (1 + 2 + 10 - 7) + 40);
}

}  // namespace faster::testing::scan_designs_test
