#include <catch2/catch.hpp>
#include <cstdint>

#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/keys.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"
#include "support/random_stimulus.hpp"
#include "support/run_cells.hpp"
#include "support/test_run.hpp"

namespace faster::testing::sensitivities_test {

struct Trial {
    AcceleratorConfig config;
    Stimulus stimulus;
};

Trial random_trial(std::uint64_t seed) {
    RandomConfigOptions config;
    config.cores = {1, 3};
    config.fifo_depth = {1, 12};
    config.any_region = true;
    RandomStimulusOptions stimulus;
    stimulus.width = {24, 48};
    stimulus.height = {24, 48};
    stimulus.window = {4, 16};
    stimulus.samples = {1, 5};
    return {random_config(seed, config), random_stimulus(seed, stimulus)};
}

RunConfig run_config(AcceleratorConfig const& accelerator) {
    RunConfig config;
    accelerator_of(config) = accelerator;
    return config;
}

/// Runs the step, and counts those that change something.
void check_step(Trial const& trial, Cycles total, Key const& key, std::int64_t value, SensitivityStep const& step,
                std::size_t& changes) {
    if (!step.valid)
        return;
    CAPTURE(key.name(), value);
    RunConfig changed = run_config(trial.config);
    key.write(changed, KeyValue{value});
    RunStatistics const run = test_run(accelerator_of(changed), trial.stimulus, Engine::decoupled).statistics;
    REQUIRE(step.deadlocks == run.deadlocked());
    CHECK(step.total_cycles == (run.deadlocked() ? 0 : run.total_cycles));
    changes += run.deadlocked() || run.total_cycles != total ? 1U : 0U;
}

std::size_t check_all_steps(Trial const& trial, Engine engine) {
    TestRunOptions options;
    options.sensitivities = true;
    RunStatistics const run = test_run(trial.config, trial.stimulus, engine, options).statistics;
    Keys const keys = timing_keys(run_config(trial.config));
    REQUIRE(run.sensitivities.size() == keys.size());
    std::size_t changes = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Sensitivity const& row = run.sensitivities[i];
        REQUIRE(row.key == keys[i].name());
        check_step(trial, run.total_cycles, keys[i], row.value - 1, row.down, changes);
        check_step(trial, run.total_cycles, keys[i], row.value + 1, row.up, changes);
    }
    return changes;
}

TEST_CASE("A step of any timing key changes the total as a run with it says", "[sensitivities]") {
    std::size_t changes = 0;
    for (std::uint64_t seed = 8000; seed < 8003; ++seed) {
        CAPTURE(seed);
        changes += check_all_steps(random_trial(seed), seed % 2 == 0 ? Engine::decoupled : Engine::lockstep);
    }
    CHECK(changes > 25);
}

TEST_CASE("So it does where one loop prepares and scans all triangles", "[sensitivities]") {
    for (std::uint64_t seed = 8020; seed < 8022; ++seed) {
        CAPTURE(seed);
        Trial trial = random_trial(seed);
        trial.config.rasterizer = {ScanPolicy::spans, seed - 8019};
        trial.config.inlier_unit.fragment_loop = FragmentLoop::flattened;
        trial.config.fifo(FifoId::area).depth = 8;
        CHECK(check_all_steps(trial, seed % 2 == 0 ? Engine::decoupled : Engine::lockstep) > 5);
    }
}

TEST_CASE("So it does with double buffers, of a window and of a touched region", "[sensitivities]") {
    for (std::uint64_t seed = 8030; seed < 8032; ++seed) {
        CAPTURE(seed);
        Trial trial = random_trial(seed);
        trial.config.inlier_unit.sweep_region = seed % 2 == 0 ? SweepRegion::window : SweepRegion::touched;
        trial.config.edge_map.buffers = 2;
        trial.config.inlier_unit.buffers = 2;
        CHECK(check_all_steps(trial, seed % 2 == 0 ? Engine::decoupled : Engine::lockstep) > 5);
    }
}

TEST_CASE("So it does where the scan tests several pixels at a time", "[sensitivities][lanes]") {
    Trial trial = random_trial(8031);
    trial.config.edge_map.algorithm = EdgeMapAlgorithm::inner_border;
    trial.config.rasterizer = {ScanPolicy::spans, 3, EdgeTokens::object, 4};
    trial.config.fifo(FifoId::area).depth = 8;
    CHECK(check_all_steps(trial, Engine::decoupled) > 5);
}

TEST_CASE("The FIFOs of other generations change the total as a run with them says", "[sensitivities]") {
    std::size_t alternatives = 0;
    std::size_t changes = 0;
    for (std::uint64_t seed = 8040; seed < 8052; ++seed) {
        CAPTURE(seed);
        Trial trial = random_trial(seed);
        TestRunOptions options;
        options.sensitivities = true;
        RunStatistics const run = test_run(trial.config, trial.stimulus, Engine::decoupled, options).statistics;
        for (Alternative const& row : run.alternatives) {
            CAPTURE(row.value, row.other);
            CHECK(row.key == "accelerator.fifo_rules");
            CHECK(row.value == choice_name(trial.config.fifo_rules));
            Trial changed = trial;
            changed.config.fifo_rules = choice_from_name<FifoGeneration>(row.other);
            RunStatistics const other = test_run(changed.config, trial.stimulus, Engine::lockstep).statistics;
            REQUIRE(row.step.deadlocks == other.deadlocked());
            CHECK(row.step.total_cycles == (other.deadlocked() ? 0 : other.total_cycles));
            changes += other.deadlocked() || other.total_cycles != run.total_cycles ? 1U : 0U;
            ++alternatives;
        }
    }
    CHECK(alternatives >= 20);
    CHECK(changes > 5);
}

TEST_CASE("FIFOs of depth 2 are the same in every generation", "[sensitivities]") {
    Trial trial = random_trial(8010);
    for (FifoGeneration const rules : {FifoGeneration::spec, FifoGeneration::vivado_hls, FifoGeneration::vitis_hls}) {
        trial.config = AcceleratorConfig();
        trial.config.cores = 2;
        RunStatistics const as_in_spec = test_run(trial.config, trial.stimulus, Engine::decoupled).statistics;
        trial.config.fifo_rules = rules;
        TestRunOptions options;
        options.sensitivities = true;
        RunStatistics const run = test_run(trial.config, trial.stimulus, Engine::decoupled, options).statistics;
        CHECK(first_difference(all_cells(run), all_cells(as_in_spec)) == "");
        CHECK(run.alternatives.empty());
    }
}

TEST_CASE("Steps that deadlock are known", "[sensitivities]") {
    Trial trial = random_trial(8010);
    trial.config = AcceleratorConfig();
    trial.config.cores = 2;
    check_all_steps(trial, Engine::decoupled);
    TestRunOptions options;
    options.sensitivities = true;
    std::size_t deadlocks = 0;
    for (Sensitivity const& row :
         test_run(trial.config, trial.stimulus, Engine::decoupled, options).statistics.sensitivities)
        deadlocks += row.down.deadlocks ? 1U : 0U;
    CHECK(deadlocks >= 2);  // fragment_depth and fragment_index of depth 1
}

}  // namespace faster::testing::sensitivities_test
