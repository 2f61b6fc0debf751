#include <catch2/catch.hpp>
#include <utility>

#include "faster/dataflow_names.hpp"
#include "support/counters.hpp"
#include "support/raster_machine.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::map_clearing_test {

AcceleratorConfig machine(NeighbourAccess access, MapClearing clearing) {
    AcceleratorConfig config = with_cores(1);
    config.inlier_unit.neighbour_access = access;
    config.inlier_unit.clearing = clearing;
    config.edge_map.clearing = clearing;
    return config;
}

Cycles sweep_ii(AcceleratorConfig const& config) { return initiation_interval(LoopId::sweep, config).achieved; }

LoopStatistics const& loop_of(RunStatistics const& run, LoopId id) { return run.cores.at(0).loops[index_of(id)]; }

TEST_CASE("Line buffers bring the sweep to II 1, clearing on read-out costs it an access", "[map_clearing]") {
    CHECK(sweep_ii(machine(NeighbourAccess::direct, MapClearing::loop)) == 3);
    CHECK(sweep_ii(machine(NeighbourAccess::direct, MapClearing::on_read_out)) == 3);  // 6 accesses on 2 ports
    CHECK(sweep_ii(machine(NeighbourAccess::window, MapClearing::loop)) == 1);
    AcceleratorConfig both = machine(NeighbourAccess::window, MapClearing::on_read_out);
    CHECK(sweep_ii(both) == 1);
    CHECK(initiation_interval(LoopId::output, both).achieved == 1);
    both.memory(BramId::depth_buffer).ports = 1;
    both.memory(BramId::edge_map).ports = 1;
    CHECK(sweep_ii(both) == 2);
    CHECK(initiation_interval(LoopId::output, both).achieved == 2);
}

TEST_CASE("Line buffers hold two rows", "[map_clearing]") {
    AcceleratorConfig config = machine(NeighbourAccess::window, MapClearing::loop);
    CHECK(line_buffer_shape(config).words == 200);
    CHECK(line_buffer_shape(config).bits == 22);
    CHECK(ramb36_count(line_buffer_shape(config)) == 1);
    config.edge_map.algorithm = EdgeMapAlgorithm::inner_border;  // needs no neighbours
    CHECK(line_buffer_shape(config).words == 0);
    CHECK(line_buffer_shape(machine(NeighbourAccess::direct, MapClearing::loop)).words == 0);
}

TEST_CASE("Without triangles, line buffers and clearing on read-out take W^2 + W + 16 cycles", "[map_clearing]") {
    // The end command is read in cycle 4, the sweep is entered at T = 6 and takes its first edge bit W + 1 steps later,
    // when it has long been there. Its W^2 + W + 1 iterations and 7 more stages end at W^2 + W + 14, in which the
    // result leaves; it is read a cycle later. The next sample: 1 to begin, 1 to read its end, 1 to turn, the sweep, 1
    // for the result.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    AcceleratorConfig const config = machine(NeighbourAccess::window, MapClearing::on_read_out);
    for (int const window : {8, 33, 200}) {
        auto const side = static_cast<Cycles>(window);
        Cycles const sweep = side * side + side + 8;
        for (int const samples : {1, 2, 3}) {
            CAPTURE(engine, window, samples);
            RunStatistics const run = test_run(config, empty_stimulus(window, samples), engine).statistics;
            CHECK(run.total_cycles == sweep + 8 + static_cast<Cycles>(samples - 1) * (sweep + 4));
            CHECK(loop_of(run, LoopId::depth_clear).iterations == 0);
            CHECK(loop_of(run, LoopId::edge_clear).iterations == 0);
            CHECK(loop_of(run, LoopId::sweep).iterations == static_cast<Cycles>(samples) * (side * side + side + 1));
        }
    }
}

TEST_CASE("Without triangles, lanes divide the sweep of line buffers and clearing on read-out",
          "[map_clearing][lanes]") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (int const window : {8, 33, 200})
        for (int const lanes : {1, 3, 4, window}) {
            AcceleratorConfig config = machine(NeighbourAccess::window, MapClearing::on_read_out);
            config.window = window;
            config.inlier_unit.sweep_lanes = lanes;
            auto const side = static_cast<Cycles>(window);
            auto const row = (side + static_cast<Cycles>(lanes) - 1) / static_cast<Cycles>(lanes);
            for (BramId const bram : bram_ids)
                config.memory(bram).partition = {PartitionType::cyclic, static_cast<std::uint64_t>(lanes), 2};
            Cycles const sweep = side * row + row + 8;
            // The line buffers fill from cycle 6 to 6 + row; the first edge bits are there in cycle 10.
            Cycles const wait = row < 3 ? 3 - row : 0;
            CAPTURE(engine, window, lanes);
            for (int const samples : {1, 3}) {
                RunStatistics const run = test_run(config, empty_stimulus(window, samples), engine).statistics;
                CHECK(run.total_cycles == sweep + 8 + wait + static_cast<Cycles>(samples - 1) * (sweep + 4));
                CHECK(run.cores.at(0).fifos[index_of(FifoId::edge_map)].writes ==
                      static_cast<Cycles>(samples) * side * row);
            }
        }
}

TEST_CASE("Lanes need banks, for themselves and for their neighbours", "[map_clearing][lanes]") {
    AcceleratorConfig config = machine(NeighbourAccess::direct, MapClearing::loop);
    config.inlier_unit.sweep_lanes = 4;
    CHECK(sweep_ii(config) == 7);  // 14 words
    CHECK(initiation_interval(LoopId::output, config).achieved == 2);
    config.memory(BramId::depth_buffer).partition = {PartitionType::cyclic, 4, 2};
    CHECK(sweep_ii(config) == 2);
    config.inlier_unit.neighbour_access = NeighbourAccess::window;
    CHECK(sweep_ii(config) == 1);
    config.inlier_unit.clearing = MapClearing::on_read_out;
    CHECK(sweep_ii(config) == 1);
    CHECK(line_buffer_shape(config).words == 50);
    CHECK(line_buffer_shape(config).bits == 88);
}

TEST_CASE("Wide clearing takes as long as the largest bank has words", "[map_clearing][partition]") {
    AcceleratorConfig config = machine(NeighbourAccess::direct, MapClearing::wide);
    auto const iterations = [&config] {
        RunStatistics const run = test_run(config, empty_stimulus(10, 2), Engine::decoupled).statistics;
        return std::pair{loop_of(run, LoopId::edge_clear).iterations, loop_of(run, LoopId::depth_clear).iterations};
    };
    config.window = 10;
    CHECK(iterations() == std::pair<std::uint64_t, std::uint64_t>{200, 200});
    config.memory(BramId::edge_map).partition = {PartitionType::cyclic, 3, 2};
    CHECK(iterations() == std::pair<std::uint64_t, std::uint64_t>{200, 200});  // the object map is one bank still
    config.memory(BramId::object_map).partition = {PartitionType::block, 4, 0};
    config.memory(BramId::depth_buffer).partition = {PartitionType::cyclic, 10, 1};
    CHECK(iterations() == std::pair<std::uint64_t, std::uint64_t>{80, 20});
    CHECK(initiation_interval(LoopId::edge_clear, config).achieved == 1);
}

TEST_CASE("How maps are cleared and read changes no result", "[map_clearing]") {
    RunStatistics const plain =
        test_run(machine(NeighbourAccess::direct, MapClearing::loop), one_small_triangle(), Engine::decoupled)
            .statistics;
    for (NeighbourAccess const access : {NeighbourAccess::direct, NeighbourAccess::window})
        for (MapClearing const clearing : {MapClearing::loop, MapClearing::on_read_out}) {
            RunStatistics const run =
                test_run(machine(access, clearing), one_small_triangle(), Engine::decoupled).statistics;
            CHECK(counters_of(run.samples.at(0)).inlier == counters_of(plain.samples.at(0)).inlier);
            CHECK(counters_of(run.samples.at(0)).edge_inlier == counters_of(plain.samples.at(0)).edge_inlier);
            CHECK(counters_of(run.samples.at(0)).valid_edge == counters_of(plain.samples.at(0)).valid_edge);
        }
}

}  // namespace faster::testing::map_clearing_test
