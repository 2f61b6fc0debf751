#include <algorithm>
#include <catch2/catch.hpp>

#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "faster/dataflow_names.hpp"
#include "support/engine_agreement.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/run_cells.hpp"
#include "support/small_stimulus.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing::fpga_grip_test {

AcceleratorConfig fpga_grip() {
    AcceleratorConfig config = with_cores(1);
    config.flow = Flow::fpga_grip;
    return config;
}

/// Every other one with banks, lanes of sweep and scan, and other ways to clear.
AcceleratorConfig random_machine(std::uint64_t seed, Stimulus const& stimulus, bool is_deadlock_free) {
    RandomConfigOptions options;
    options.flow = Flow::fpga_grip;
    options.cores = {1, 4};
    options.any_clearing = seed % 2 == 0;
    options.any_partition = seed % 2 == 0;
    options.max_lanes = seed % 2 == 0 ? std::min(stimulus.window, 5) : 1;
    options.max_scan_lanes = seed % 2 == 0 ? 5 : 1;
    options.is_deadlock_free = is_deadlock_free;
    options.any_region = true;
    AcceleratorConfig config = random_config(seed, options);
    adopt(stimulus, config);
    return config;
}

Stimulus random_work(std::uint64_t seed) {
    RandomStimulusOptions options;
    options.width = {24, 64};
    options.height = {24, 64};
    options.window = {4, 24};
    options.samples = {0, 6};
    options.random_fraction_bits = seed % 3 == 0;
    return random_stimulus(seed, options);
}

LoopStatistics const& loop_of(RunStatistics const& run, LoopId id) { return run.cores.at(0).loops[index_of(id)]; }

Cycles extract_ii(NeighbourAccess access, int neighbourhood, std::uint64_t ports = 2) {
    AcceleratorConfig config = fpga_grip();
    config.edge_extraction.neighbour_access = access;
    config.edge_extraction.neighbourhood = neighbourhood;
    config.memory(BramId::depth_buffer).ports = ports;
    return initiation_interval(LoopId::extract, config).achieved;
}

/// Figures of both engines and the twin. False: it deadlocked.
bool check_seed(std::uint64_t seed, bool is_deadlock_free) {
    CAPTURE(seed);
    Stimulus const stimulus = random_work(seed);
    return check_agreement(random_machine(seed, stimulus, is_deadlock_free), stimulus);
}

TEST_CASE("Engines and twin agree on flow fpga_grip: deadlock-free machines", "[fpga_grip][engine_vs_twin]") {
    for (std::uint64_t seed = 8100; seed < 8180; ++seed)
        CHECK(check_seed(seed, true));
}

TEST_CASE("Engines and twin agree on flow fpga_grip: any machine", "[fpga_grip][engine_vs_twin]") {
    int finished = 0;
    for (std::uint64_t seed = 8200; seed < 8240; ++seed)
        finished += check_seed(seed, false) ? 1 : 0;
    CHECK(finished > 4);
    CHECK(finished < 36);
}

TEST_CASE("Without triangles flow fpga_grip takes 3 W^2 + r (W + 1) + 99 cycles", "[fpga_grip]") {
    // Clearing ends at T = W^2 + 2; the end command is read, and seen: W^2 + 4. The extraction of W^2 + r (W + 1)
    // iterations has 12 + 28 + 46 stages; a cycle later the sweep of W^2 iterations and 8 stages begins, whose
    // observation has long been there. The result leaves in the cycle after its last step, and is read one later.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (int const window : {8, 33, 200})
        for (int const samples : {1, 2, 3}) {
            CAPTURE(engine, window, samples);
            auto const side = static_cast<Cycles>(window);
            Cycles const lead = 2 * (side + 1);
            Cycles const each = 3 * side * side + lead + 98;
            RunStatistics const run = test_run(fpga_grip(), empty_stimulus(window, samples), engine).statistics;
            CHECK(run.total_cycles == each + 1 + static_cast<Cycles>(samples - 1) * each);
            CHECK(loop_of(run, LoopId::extract).depth == 86);
            CHECK(loop_of(run, LoopId::extract).iterations == static_cast<Cycles>(samples) * (side * side + lead));
            CHECK(loop_of(run, LoopId::sweep).ii == 1);
        }
}

TEST_CASE("Line buffers bring the extraction to II 1, and without them every neighbour is read", "[fpga_grip]") {
    CHECK(extract_ii(NeighbourAccess::window, 3) == 1);
    CHECK(extract_ii(NeighbourAccess::window, 15) == 1);
    CHECK(extract_ii(NeighbourAccess::window, 5, 1) == 2);
    CHECK(extract_ii(NeighbourAccess::direct, 3) == 5);   // 9 reads and a write
    CHECK(extract_ii(NeighbourAccess::direct, 5) == 13);  // 25 and one
    CHECK(extract_ii(NeighbourAccess::direct, 3, 10) == 1);
}

TEST_CASE("Flow fpga_grip has a depth buffer of twelve bits, line buffers, and no maps", "[fpga_grip]") {
    AcceleratorConfig config = fpga_grip();
    CHECK(memory_shape(BramId::edge_map, config).words == 0);
    CHECK(memory_shape(BramId::object_map, config).words == 0);
    CHECK(memory_shape(BramId::depth_buffer, config).bits == 12);
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 15);  // as eleven bits do
    CHECK(line_buffer_shape(config).bits == 44);
    CHECK(ramb36_count(line_buffer_shape(config)) == 2);
    config.edge_extraction.neighbourhood = 3;
    CHECK(line_buffer_shape(config).bits == 22);
    CHECK(ramb36_count(line_buffer_shape(config)) == 1);
    config.edge_extraction.neighbour_access = NeighbourAccess::direct;
    CHECK(line_buffer_shape(config).words == 0);
}

TEST_CASE("A recorded run of flow fpga_grip retimes to what a run takes", "[fpga_grip][events]") {
    test::TempFolder const folder;
    for (std::uint64_t seed = 8300; seed < 8312; ++seed) {
        CAPTURE(seed);
        Stimulus const stimulus = random_work(seed);
        AcceleratorConfig const config = random_machine(seed, stimulus, true);
        TestRunOptions options;
        options.events = folder / "events";
        RunStatistics const run = test_run(config, stimulus, Engine::decoupled, options).statistics;
        events::EventFile const file = events::read_event_file(folder / "events");
        CHECK(first_difference(all_cells(replay::retime(file.run, raster_machine(config))), all_cells(run)) == "");
        AcceleratorConfig changed = config;
        changed.edge_extraction.square_root_latency += 7;
        changed.fifo(FifoId::command).depth = fifo_of(config, FifoId::command).depth + 3;
        changed.loop(LoopId::extract).ii = testing::loop_of(config, LoopId::extract).ii + 1;
        CHECK(first_difference(all_cells(replay::retime(file.run, raster_machine(changed))),
                               all_cells(test_run(changed, stimulus, Engine::decoupled).statistics)) == "");
    }
}

TEST_CASE("The rows of the critical path of flow fpga_grip add up", "[fpga_grip][critical_path]") {
    TestRunOptions traced;
    traced.critical_path = true;
    Cycles in_extraction = 0;
    for (std::uint64_t seed = 8400; seed < 8420; ++seed) {
        CAPTURE(seed);
        Stimulus const stimulus = random_work(seed);
        AcceleratorConfig const config = random_machine(seed, stimulus, true);
        RunStatistics const run = test_run(config, stimulus, Engine::decoupled, traced).statistics;
        auto const lockstep = test_run(config, stimulus, Engine::lockstep, traced).statistics;
        Cycles sum = 0;
        for (PathRow const& row : run.critical_path.value().rows) {
            sum += row.cycles;
            in_extraction += row.loop == index_of(LoopId::extract) ? row.cycles : 0;
            CHECK(run.machine.processes.at(row.module).is_present);
        }
        CHECK(sum == run.total_cycles);
        CHECK(first_difference(path_cells(run), path_cells(lockstep)) == "");
    }
    CHECK(in_extraction > 0);
}

}  // namespace faster::testing::fpga_grip_test
