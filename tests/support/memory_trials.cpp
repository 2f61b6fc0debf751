#include "support/memory_trials.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "dataflow/run/events/event_file.hpp"
#include "faster/dataflow_names.hpp"
#include "support/engine_agreement.hpp"
#include "support/plain_config.hpp"
#include "support/random_memory.hpp"
#include "support/random_stimulus.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing {
namespace {

/// Tokens of many pixels lie across beats and bursts, which few others do.
bool has_wide_tokens(std::uint64_t seed) { return seed % 6 == 0; }

/// A thousand pixels are what there is room for at first of what comes from memory.
bool has_large_window(std::uint64_t seed) { return seed >= first_with_large_windows; }

RandomStimulusOptions stimuli(std::uint64_t seed) {
    RandomStimulusOptions options;
    options.width = {24, 64};
    options.height = {24, 64};
    options.window = has_wide_tokens(seed) ? IntRange{16, 24} : IntRange{4, 20};
    if (has_large_window(seed))
        options.window = {33, 48};
    options.samples = {0, seed % 5 == 0 ? 24 : 8};
    options.random_fraction_bits = seed % 3 == 0;
    return options;
}

RandomConfigOptions machines(std::uint64_t seed) {
    RandomConfigOptions options;
    options.cores = {1, seed % 2 == 0 ? 12 : 4};
    options.is_deadlock_free = seed % 4 != 0;
    if (seed % 4 == 0)
        options.fifo_depth = {1, 8};
    if (seed % 11 == 0)
        options.flow = Flow::fpga_grip;
    if (seed % 3 != 0)
        return options;
    options.any_scan = true;
    options.any_clearing = true;
    options.any_buffers = true;
    options.any_region = true;
    options.max_lanes = has_wide_tokens(seed) ? 16 : 4;
    return options;
}

}  // namespace

AcceleratorConfig other_timing(std::uint64_t seed, AcceleratorConfig config) {
    std::mt19937_64 random(seed);
    draw_memory_timing(~seed, config);
    config.cores = 1 + random() % 12;
    config.memory_placement.observation_copies = 1 + random() % config.cores;
    for (FifoId const fifo : {FifoId::vertex, FifoId::command, FifoId::observed_depth, FifoId::edge_token})
        config.fifo(fifo).depth = fifo_of(config, fifo).depth + random() % 8;
    return config;
}

int check_memory_retimings(std::uint64_t first, std::uint64_t count) {
    int recorded = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CAPTURE(seed);
        MemoryTrial const trial = memory_trial(seed);
        test::TempFolder const folder;
        TestRunOptions fork;
        fork.events = folder / "events";
        if (test_run(trial.config, trial.stimulus, Engine::decoupled, fork).statistics.deadlocked())
            continue;
        ++recorded;
        events::EventFile const file = events::read_event_file(fork.events);
        AcceleratorConfig const other = other_timing(seed, trial.config);
        check_retiming(file.run, trial.config, trial.stimulus);
        check_retiming(file.run, other, trial.stimulus);
        check_agreement(other, trial.stimulus);
        AcceleratorConfig ideal = other;
        ideal.external_memory.model = MemoryModel::ideal;
        check_retiming(file.run, ideal, trial.stimulus);
    }
    return recorded;
}

MemoryTrial memory_trial(std::uint64_t seed) {
    MemoryTrial trial{random_stimulus(seed, stimuli(seed)), random_config(seed, machines(seed))};
    draw_memory(seed, trial.config);
    adopt(trial.stimulus, trial.config);
    return trial;
}

int check_memory_seeds(std::uint64_t first, std::uint64_t count) {
    int deadlocks = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CAPTURE(seed);
        MemoryTrial const trial = memory_trial(seed);
        deadlocks += check_agreement(trial.config, trial.stimulus) ? 0 : 1;
    }
    return deadlocks;
}

}  // namespace faster::testing
