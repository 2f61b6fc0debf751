#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/run_cells.hpp"
#include "support/test_run.hpp"

namespace faster::testing::critical_path_test {

struct Trial {
    AcceleratorConfig config;
    Stimulus stimulus;
};

Trial trial_of(std::uint64_t seed, IntRange fifo_depth = {1, 64}) {
    RandomConfigOptions config;
    config.cores = {1, 3};
    config.fifo_depth = fifo_depth;
    RandomStimulusOptions stimulus;
    stimulus.width = {24, 64};
    stimulus.height = {24, 64};
    stimulus.window = {4, 24};
    stimulus.samples = {0, 6};
    return {random_config(seed, config), random_stimulus(seed, stimulus)};
}

TestRunOptions traced(std::size_t trail_length = timing::Trail::usual_length) {
    TestRunOptions options;
    options.critical_path = true;
    options.trail_length = trail_length;
    return options;
}

RunStatistics trace(Trial const& trial, Engine engine = Engine::decoupled, TestRunOptions const& options = traced()) {
    return test_run(trial.config, trial.stimulus, engine, options).statistics;
}

Cycles total_of(AcceleratorConfig const& config, Stimulus const& stimulus) {
    return test_run(config, stimulus, Engine::decoupled).statistics.total_cycles;
}

Cycles sum_of(RunStatistics const& run) {
    Cycles sum = 0;
    for (PathRow const& row : run.critical_path.value().rows)
        sum += row.cycles;
    return sum;
}

template <class Wanted> Cycles cycles_where(RunStatistics const& run, Wanted wanted) {
    Cycles sum = 0;
    for (PathRow const& row : run.critical_path.value().rows)
        sum += wanted(row) ? row.cycles : 0;
    return sum;
}

/// A machine whose FIFOs are all the same but for their names, so that one step changes one thing.
Trial plain_trial(std::uint64_t seed) {
    Trial trial = trial_of(seed);
    trial.config = AcceleratorConfig();
    trial.config.cores = 1 + seed % 2;
    for (FifoId const id : fifo_ids) {
        trial.config.fifo(id).kind = FifoKind::shift_register;
        trial.config.fifo(id).depth = 4;
    }
    return trial;
}

TEST_CASE("The critical path adds up to the total, the same from both engines: seeds 7000 to 7079", "[critical_path]") {
    for (std::uint64_t seed = 7000; seed < 7080; ++seed) {
        CAPTURE(seed);
        Trial const trial = trial_of(seed, seed % 2 == 0 ? IntRange{1, 64} : IntRange{2, 3});
        RunStatistics const decoupled = trace(trial);
        REQUIRE_FALSE(decoupled.deadlocked());
        CHECK(sum_of(decoupled) == decoupled.total_cycles);
        CHECK(first_difference(path_cells(trace(trial, Engine::lockstep)), path_cells(decoupled)) == "");
        CHECK(first_difference(all_cells(test_run(trial.config, trial.stimulus, Engine::decoupled).statistics),
                               all_cells(decoupled)) == "");
    }
}

TEST_CASE("The critical path adds up with long intervals, few ports and shallow loops too", "[critical_path]") {
    for (std::uint64_t seed = 7400; seed < 7430; ++seed) {
        CAPTURE(seed);
        RandomConfigOptions config;
        config.cores = {1, 2};
        config.max_target_ii = 12;
        config.max_recurrence_ii = 12;
        config.max_ports = 1;
        RandomStimulusOptions stimulus;
        stimulus.window = {1, 10};
        stimulus.triangles = {0, 6};
        Trial const trial{random_config(seed, config), random_stimulus(seed, stimulus)};
        RunStatistics const decoupled = trace(trial);
        CHECK(sum_of(decoupled) == decoupled.total_cycles);
        CHECK(first_difference(path_cells(trace(trial, Engine::lockstep)), path_cells(decoupled)) == "");
    }
}

TEST_CASE("The critical path adds up for any way to prepare and to scan triangles", "[critical_path]") {
    std::size_t waits_for_setups = 0;
    for (std::uint64_t seed = 7500; seed < 7540; ++seed) {
        CAPTURE(seed);
        RandomConfigOptions config;
        config.cores = {1, 2};
        config.any_scan = true;
        if (seed % 2 == 1) {
            config.algorithm = EdgeMapAlgorithm::inner_border;
            config.max_scan_lanes = 8;
        }
        config.any_region = true;
        RandomStimulusOptions stimulus;
        stimulus.window = {4, 24};
        Trial const trial{random_config(seed, config), random_stimulus(seed, stimulus)};
        RunStatistics const decoupled = trace(trial);
        REQUIRE_FALSE(decoupled.deadlocked());
        CHECK(sum_of(decoupled) == decoupled.total_cycles);
        CHECK(first_difference(path_cells(trace(trial, Engine::lockstep)), path_cells(decoupled)) == "");
        bool const waits =
            cycles_where(decoupled, [](PathRow const& row) { return row.cause == PathCause::setup; }) > 0;
        waits_for_setups += waits && trial.config.rasterizer.setup_overlap > 0 ? 1U : 0U;
    }
    CHECK(waits_for_setups > 0);
}

TEST_CASE("Forgetting what all paths have in common changes nothing", "[critical_path]") {
    for (std::uint64_t seed = 7100; seed < 7140; ++seed) {
        CAPTURE(seed);
        Trial const trial = trial_of(seed, seed % 2 == 0 ? IntRange{1, 64} : IntRange{2, 3});
        Cells const whole = path_cells(trace(trial));
        for (Engine const engine : {Engine::lockstep, Engine::decoupled})
            CHECK(first_difference(path_cells(trace(trial, engine, traced(16))), whole) == "");
    }
}

TEST_CASE("The critical path is empty without samples, and missing of a deadlocked run", "[critical_path]") {
    Trial trial = plain_trial(7200);
    trial.stimulus.samples.clear();
    CHECK(trace(trial).critical_path.value().rows.empty());
    trial = plain_trial(7201);
    trial.config.fifo(FifoId::fragment_depth).depth = 1;
    RunStatistics const stuck = trace(trial);
    REQUIRE(stuck.deadlocked());
    CHECK_FALSE(stuck.critical_path.has_value());
}

TEST_CASE("What makes a row of the critical path longer makes the run longer by as much, at least", "[critical_path]") {
    std::uint64_t exact = 0;
    std::uint64_t compared = 0;
    for (std::uint64_t seed = 7300; seed < 7312; ++seed) {
        Trial const trial = plain_trial(seed);
        RunStatistics const run = trace(trial);
        auto const check = [&](std::string const& what, Cycles on_path, AcceleratorConfig const& longer) {
            CAPTURE(seed, what, on_path);
            Cycles const added = total_of(longer, trial.stimulus) - run.total_cycles;
            CHECK(added >= on_path);
            CHECK(added <= run.total_cycles + on_path);  // not below zero
            exact += added == on_path ? 1 : 0;
            ++compared;
        };
        AcceleratorConfig longer = trial.config;
        longer.setup("rasterizer") = setup_depth_of(longer) + 1;
        check("setup",
              cycles_where(run, [](PathRow const& row) { return row.cause == PathCause::setup; }) /
                  setup_depth_of(trial.config),
              longer);
        for (FifoId const fifo : fifo_ids) {
            longer = trial.config;
            longer.fifo(fifo).kind = FifoKind::memory;  // as much room, one cycle more of read latency
            longer.fifo(fifo).depth = fifo_of(trial.config, fifo).depth - 1;
            check(std::string("read latency of ") + fifo.name,
                  cycles_where(run,
                               [fifo](PathRow const& row) {
                                   return row.cause == PathCause::read_latency && *row.fifo == index_of(fifo);
                               }),
                  longer);
        }
        for (LoopId const loop : loop_ids) {
            std::size_t const l = index_of(loop);
            auto const of_loop = [l](PathCause cause) {
                return [l, cause](PathRow const& row) { return row.cause == cause && row.loop == l; };
            };
            longer = trial.config;
            longer.loop(loop).ii = run.cores.front().loops[l].ii + 1;
            // Where the interval has more than one cycle, all of them are one iteration's.
            Cycles const iterations =
                (cycles_where(run, of_loop(PathCause::busy)) + cycles_where(run, of_loop(PathCause::port_conflict))) /
                run.cores.front().loops[l].ii;
            Cycles const entries_at_most = run.cores[run.critical_path->core].loops[l].entries * 2;
            CAPTURE(entries_at_most);
            check(std::string("interval of loop ") + loop.name, iterations - std::min(iterations, entries_at_most),
                  longer);
        }
    }
    CHECK(exact * 4 > compared);  // a path that is far too short would pass as well
}

}  // namespace faster::testing::critical_path_test
