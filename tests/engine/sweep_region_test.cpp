#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/counters.hpp"
#include "support/engine_agreement.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::sweep_region_test {

AcceleratorConfig touching() {
    AcceleratorConfig config = with_cores(1);
    config.inlier_unit.sweep_region = SweepRegion::touched;
    return config;
}

/// Iterations of the sweep, whose process depends on the buffers.
std::uint64_t swept(RunStatistics const& run) {
    auto const& loops = run.cores.at(0).loops;
    return loops[index_of(LoopId::sweep)].iterations + loops[index_of(LoopId::buffered_sweep)].iterations;
}
LoopStatistics const& loop_of(RunStatistics const& run, LoopId id) { return run.cores.at(0).loops[index_of(id)]; }
FifoStatistics const& fifo_of(RunStatistics const& run, FifoId id) { return run.cores.at(0).fifos[index_of(id)]; }

RunStatistics run_of(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine = Engine::decoupled) {
    return test_run(config, stimulus, engine).statistics;
}

/// That of one_small_triangle(), in a corner of a larger window.
Stimulus small_triangle_in(int window) {
    Stimulus stimulus = empty_stimulus(window, 1);
    stimulus.triangles = one_small_triangle().triangles;
    stimulus.samples[0].triangle_count = 1;
    return stimulus;
}

TEST_CASE("Without triangles nothing is swept, and a sample takes W^2 + 8 cycles", "[sweep_region]") {
    // The maps are cleared at T = W^2 + 2. The end command, the corners, no sweep: the result leaves at W^2 + 6 and is
    // read a cycle later. The next sample begins to clear a cycle after the result: 1, W^2 + 1, 1, 2, 1, 1 cycles.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (int const samples : {1, 2, 3}) {
        CAPTURE(samples);
        RunStatistics const run = run_of(touching(), empty_stimulus(33, samples), engine);
        Cycles const pixels = 33 * 33;
        CHECK(run.total_cycles == pixels + 8 + static_cast<Cycles>(samples - 1) * (pixels + 7));
        CHECK(loop_of(run, LoopId::sweep).entries == 0);
        CHECK(loop_of(run, LoopId::output).entries == 0);
        CHECK(loop_of(run, LoopId::read).iterations == 4 * static_cast<std::uint64_t>(samples));
        for (SampleStatistics const& sample : run.samples)
            CHECK(counters_of(sample).valid_depth == 31 * 31);
    }
}

TEST_CASE("A triangle is swept with a pixel around it, and all of the window counts", "[sweep_region]") {
    Stimulus const stimulus = small_triangle_in(24);
    RunStatistics const whole = run_of(with_cores(1), stimulus);
    RunStatistics const run = run_of(touching(), stimulus);
    CHECK(run.samples.at(0).counters == whole.samples.at(0).counters);
    CHECK(run.total_cycles < whole.total_cycles);
    CHECK(loop_of(run, LoopId::sweep).iterations == 4 * 4);
    CHECK(loop_of(run, LoopId::sweep).iterations == loop_of(run, LoopId::output).iterations);
    CHECK(loop_of(run, LoopId::sweep).iterations + 4 == loop_of(run, LoopId::read).iterations);
    CHECK(fifo_of(run, FifoId::region).writes == 2);
    CHECK(fifo_of(run, FifoId::valid_depth).reads == 1);
    CHECK(fifo_of(run, FifoId::fragment_index).reads == fifo_of(run, FifoId::fragment_depth).reads + 2);
}

TEST_CASE("Results do not depend on the swept region, whatever the machine", "[sweep_region]") {
    RandomStimulusOptions work;
    work.window = {1, 24};
    work.samples = {1, 6};
    std::uint64_t narrower = 0;
    for (std::uint64_t seed = 9700; seed < 9760; ++seed) {
        CAPTURE(seed);
        Stimulus const stimulus = random_stimulus(seed, work);
        RandomConfigOptions machine;
        machine.cores = {1, 2};
        machine.algorithm = static_cast<EdgeMapAlgorithm>(seed % 6);
        machine.any_scan = true;
        machine.any_clearing = true;
        machine.max_lanes = stimulus.window;
        machine.any_buffers = true;
        AcceleratorConfig config = random_config(seed, machine);
        config.window = stimulus.window;
        config.inlier_unit.sweep_region = SweepRegion::touched;
        RunStatistics const touched = test_run(config, stimulus, Engine::decoupled).statistics;
        config.inlier_unit.sweep_region = SweepRegion::window;
        config.edge_map.buffers = config.inlier_unit.buffers = 1;
        RunStatistics const window = test_run(config, stimulus, Engine::decoupled).statistics;
        REQUIRE(window.samples.size() == touched.samples.size());
        for (std::size_t i = 0; i < window.samples.size(); ++i)
            CHECK(window.samples[i].counters == touched.samples[i].counters);
        narrower += swept(touched) < swept(window) ? 1U : 0U;
    }
    CHECK(narrower > 30);
}

TEST_CASE("FIFOs of depth 1 do not lock a touched sweep", "[sweep_region]") {
    // But for those that carry fragments: their reader takes a command ahead (docs/timing-model.md#sources-of-time).
    RandomStimulusOptions work;
    work.window = {4, 24};
    work.samples = {2, 6};
    for (std::uint64_t seed = 9800; seed < 9830; ++seed) {
        CAPTURE(seed);
        Stimulus const stimulus = random_stimulus(seed, work);
        AcceleratorConfig config = touching();
        config.window = stimulus.window;
        config.edge_map.algorithm = static_cast<EdgeMapAlgorithm>(seed % 6);
        config.edge_map.buffers = 1 + static_cast<int>(seed / 6 % 2);
        config.inlier_unit.buffers = 1 + static_cast<int>(seed / 3 % 2);
        for (FifoId const id : fifo_ids)
            config.fifo(id).depth = 1;
        for (FifoId const id : {FifoId::command, FifoId::fragment_depth, FifoId::fragment_index})
            config.fifo(id).depth = 2;
        REQUIRE(check_agreement(config, stimulus));
    }
}

TEST_CASE("The FIFOs of a touched sweep are in its design only", "[sweep_region]") {
    for (Flow const flow : {Flow::faster, Flow::fpga_grip})
        for (FifoId const id : {FifoId::region, FifoId::valid_depth}) {
            AcceleratorConfig config;
            config.flow = flow;
            CHECK_FALSE(raster_machine(config).fifos.at(index_of(id)).is_present);
            config.inlier_unit.sweep_region = SweepRegion::touched;
            CHECK(raster_machine(config).fifos.at(index_of(id)).is_present);
        }
}

}  // namespace faster::testing::sweep_region_test
