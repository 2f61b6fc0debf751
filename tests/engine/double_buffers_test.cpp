#include <catch2/catch.hpp>
#include <map>
#include <stdexcept>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/engine_agreement.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/recorded_accesses.hpp"
#include "support/run_cells.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace faster::testing::double_buffers_test {

struct Trial {
    AcceleratorConfig config;
    Stimulus stimulus;
};

struct TrialOptions {
    Flow flow = Flow::faster;
    bool is_deadlock_free = true;
    IntRange fifo_depth{1, 64};
};

/// Algorithms, clearings, lanes, banks, scans, swept regions and buffers, one as likely as the other; every fourth is
/// plain.
Trial trial_of(std::uint64_t seed, TrialOptions const& options = {}) {
    RandomStimulusOptions work;
    work.width = {24, 64};
    work.height = {24, 64};
    work.window = {4, 24};
    work.samples = {0, 8};
    work.random_fraction_bits = seed % 5 == 0;
    RandomConfigOptions machine;
    machine.flow = options.flow;
    machine.cores = {1, 3};
    machine.fifo_depth = options.fifo_depth;
    machine.algorithm = static_cast<EdgeMapAlgorithm>(options.flow == Flow::faster ? seed / 4 % 6 : 3);
    machine.any_clearing = machine.any_scan = machine.any_partition = seed % 4 != 0;
    machine.max_lanes = seed % 4 != 0 ? 4 : 1;
    bool const may_scan_groups = options.flow == Flow::fpga_grip || machine.algorithm == EdgeMapAlgorithm::inner_border;
    machine.max_scan_lanes = may_scan_groups && seed % 3 != 0 ? 4 : 1;
    machine.any_region = true;
    machine.any_buffers = true;
    machine.is_deadlock_free = options.is_deadlock_free;
    Trial trial{random_config(seed, machine), random_stimulus(seed, work)};
    adopt(trial.stimulus, trial.config);
    return trial;
}

TestRun run(Trial const& trial, Engine engine = Engine::decoupled, TestRunOptions const& options = {}) {
    return test_run(trial.config, trial.stimulus, engine, options);
}

AcceleratorConfig with_two_of_each(std::uint64_t cores) {
    AcceleratorConfig config = with_cores(cores);
    config.edge_map.buffers = 2;
    config.inlier_unit.buffers = 2;
    return config;
}

bool check(Trial const& trial) { return check_agreement(trial.config, trial.stimulus); }

/// Who touches which buffer, and since when: accesses of a process are a sample's until the other process has the
/// buffer.
class Watch {
  public:
    void take(std::size_t core, std::size_t module, recording::PortAccess const& access) {
        Tenant& tenant = tenants_[{core, access.memory, access.buffer}];
        if (tenant.turns > 0 && tenant.module != module && access.cycle <= tenant.last)
            throw std::runtime_error(std::string("buffer ") + std::to_string(access.buffer) + " of " +
                                     bram_ids.at(access.memory).name + " changes hands in cycle " +
                                     std::to_string(access.cycle) + " from " + module_ids.at(tenant.module).name +
                                     ", last at " + std::to_string(tenant.last) + ", to " + module_ids.at(module).name);
        tenant.turns += tenant.turns == 0 || tenant.module != module ? 1 : 0;
        tenant.module = module;
        tenant.last = std::max(tenant.last, access.cycle);
    }
    /// Each sample is drawn into its buffer and read out of it, not more. A touched region may be empty.
    void finish(std::size_t samples_per_core, SweepRegion region) const {
        for (auto const& [place, tenant] : tenants_)
            if (tenant.turns > 2 * ((samples_per_core + 1) / 2))
                throw std::runtime_error("buffer " + std::to_string(std::get<2>(place)) + " of " +
                                         bram_ids.at(std::get<1>(place)).name + " changes hands too often");
        if (tenants_.size() < 4 && region == SweepRegion::window)
            throw std::runtime_error("buffers are not taken in turns");
    }

  private:
    struct Tenant {
        std::size_t module = 0;
        std::size_t turns = 0;
        Cycles last = 0;
    };
    std::map<std::tuple<std::size_t, std::size_t, std::size_t>, Tenant> tenants_;
};

/// In the simulation's process: what it throws, test_run() throws.
void watch_buffers(AcceleratorConfig const& config, std::size_t samples_per_core,
                   std::vector<recording::RecordedCore> const& cores) {
    Watch watch;
    for_each_access(cores, [&](auto const& event, auto const&, auto const& accesses) {
        for (recording::PortAccess const& access : accesses)
            watch.take(event.core, event.process, access);
    });
    watch.finish(samples_per_core, config.inlier_unit.sweep_region);
}

TEST_CASE("Engines and twin agree on double buffers: deadlock-free machines", "[double_buffers][engine_vs_twin]") {
    for (std::uint64_t seed = 20000; seed < 20140; ++seed) {
        CAPTURE(seed);
        CHECK(check(trial_of(seed)));
    }
}

TEST_CASE("Engines and twin agree on double buffers: any machine", "[double_buffers][engine_vs_twin]") {
    TrialOptions options;
    options.is_deadlock_free = false;
    options.fifo_depth = {1, 8};
    int finished = 0;
    for (std::uint64_t seed = 20200; seed < 20260; ++seed) {
        CAPTURE(seed);
        finished += check(trial_of(seed, options)) ? 1 : 0;
    }
    CHECK(finished > 5);  // or the mixture tests nothing
    CHECK(finished < 55);
}

TEST_CASE("Engines and twin agree on double buffers: flow fpga_grip", "[double_buffers][engine_vs_twin][fpga_grip]") {
    TrialOptions options;
    options.flow = Flow::fpga_grip;
    for (std::uint64_t seed = 20300; seed < 20340; ++seed) {
        CAPTURE(seed);
        CHECK(check(trial_of(seed, options)));
    }
}

TEST_CASE("Double buffers change no result, whatever is swept", "[double_buffers][sweep_region]") {
    TestRunOptions options;
    options.with_maps = true;
    for (std::uint64_t seed = 20400; seed < 20440; ++seed) {
        CAPTURE(seed);
        Trial trial = trial_of(seed);
        trial.config.edge_map.buffers = trial.config.inlier_unit.buffers = 2;
        Engine const engine = seed % 2 == 0 ? Engine::decoupled : Engine::lockstep;
        TestRun const two = run(trial, engine, options);
        trial.config.edge_map.buffers = trial.config.inlier_unit.buffers = 1;
        trial.config.inlier_unit.sweep_region = SweepRegion::window;
        TestRun const one = run(trial, engine, options);
        REQUIRE(two.statistics.samples.size() == one.statistics.samples.size());
        for (std::size_t i = 0; i < one.statistics.samples.size(); ++i) {
            CAPTURE(i);
            CHECK(two.statistics.samples[i].counters == one.statistics.samples[i].counters);
            CHECK(two.maps[i].edge_map.pixels() == one.maps[i].edge_map.pixels());
            CHECK(two.maps[i].object_map.pixels() == one.maps[i].object_map.pixels());
            CHECK(two.maps[i].depth_buffer.pixels() == one.maps[i].depth_buffer.pixels());
        }
    }
}

TEST_CASE("Without triangles and with two of each, a further sample takes its sweep and 2 cycles", "[double_buffers]") {
    // Inlier unit: cleared at T = W^2 + 2, End read, depth_full written at W^2 + 3 and read one later, sweep entered at
    // W^2 + 5. Edge map builder: T = W^2 + 2, End read, no tokens, map_full written at W^2 + 4 and read one later, loop
    // output from W^2 + 6: its first token leaves two steps later and is read at W^2 + 9. From there 3 (W^2 - 1) + 8
    // cycles to the result, which is read one later. The next sample's buffers are full by then: a step to take one,
    // the sweep, a step for the result.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (int const window : {5, 12, 33, 200})
        for (int const samples : {1, 2, 3, 5}) {
            CAPTURE(engine, window, samples);
            auto const pixels = static_cast<Cycles>(window) * static_cast<Cycles>(window);
            RunStatistics const run = test_run(with_two_of_each(1), empty_stimulus(window, samples), engine).statistics;
            CHECK(run.total_cycles == 4 * pixels + 16 + static_cast<Cycles>(samples - 1) * (3 * pixels + 7));
        }
}

TEST_CASE("Handing over buffers through FIFOs of depth 1 does not deadlock, nor take longer", "[double_buffers]") {
    for (std::uint64_t seed = 20500; seed < 20520; ++seed) {
        CAPTURE(seed);
        Trial trial = trial_of(seed);
        trial.config.edge_map.buffers = trial.config.inlier_unit.buffers = 2;
        auto const total_with = [&trial](std::uint64_t depth) {
            for (FifoId const fifo : {FifoId::map_full, FifoId::map_free, FifoId::depth_full, FifoId::depth_free})
                trial.config.fifo(fifo) = {depth, FifoKind::shift_register, Cycles{0}, std::nullopt, std::nullopt};
            RunStatistics const statistics = run(trial).statistics;
            REQUIRE_FALSE(statistics.deadlocked());
            for (FifoId const fifo : {FifoId::map_full, FifoId::map_free, FifoId::depth_full, FifoId::depth_free})
                for (CoreStatistics const& core : statistics.cores)
                    CHECK(core.fifos[index_of(fifo)].max_occupancy <= 1);
            return statistics.total_cycles;
        };
        CHECK(total_with(1) == total_with(9));
    }
}

TEST_CASE("No two samples are in one buffer at once", "[double_buffers]") {
    for (std::uint64_t seed = 20600; seed < 20640; ++seed) {
        CAPTURE(seed);
        Trial trial = trial_of(seed);
        trial.config.edge_map.buffers = trial.config.inlier_unit.buffers = 2;
        trial.config.cores = 1;
        for (LoopId const id : keyed_loop_ids)  // or a loop ends before the accesses of its last iteration
            trial.config.loop(id).depth = std::max<Cycles>(loop_of(trial.config, id).depth, 64);
        if (trial.stimulus.samples.size() < 4)
            continue;
        TestRunOptions options;
        std::size_t const samples = trial.stimulus.samples.size();
        recording::RecordingWindow window;
        if (seed % 3 != 0)  // buffers are taken up where they stand
            window.samples = {samples / 2, samples - 1};
        options.recordings.push_back({window, [&](recording::RecordedWindow const& recorded) {
                                          watch_buffers(trial.config, samples, recorded.cores);
                                      }});
        Engine const engine = seed % 2 == 0 ? Engine::decoupled : Engine::lockstep;
        CHECK_NOTHROW(run(trial, engine, options));
    }
}

TEST_CASE("The critical path adds up with double buffers, the same from both engines", "[double_buffers]") {
    std::size_t through_handovers = 0;
    for (std::uint64_t seed = 20700; seed < 20740; ++seed) {
        CAPTURE(seed);
        Trial const trial = trial_of(seed);
        TestRunOptions options;
        options.critical_path = true;
        RunStatistics const decoupled = run(trial, Engine::decoupled, options).statistics;
        Cycles sum = 0;
        for (PathRow const& row : decoupled.critical_path.value().rows) {
            sum += row.cycles;
            through_handovers += row.fifo && *row.fifo >= index_of(FifoId::map_full) ? 1U : 0U;
            CHECK(decoupled.machine.processes.at(row.module).is_present);
        }
        CHECK(sum == decoupled.total_cycles);
        CHECK(first_difference(path_cells(run(trial, Engine::lockstep, options).statistics), path_cells(decoupled)) ==
              "");
        options.trail_length = 16;
        CHECK(first_difference(path_cells(run(trial, Engine::decoupled, options).statistics), path_cells(decoupled)) ==
              "");
    }
    CHECK(through_handovers > 10);
}

}  // namespace faster::testing::double_buffers_test
