#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/run_cells.hpp"
#include "support/test_run.hpp"

namespace faster::testing::memory_engines_test {

template <class Value, std::size_t N> Value one_of(std::mt19937_64& random, std::array<Value, N> const& values) {
    return values[random() % N];
}

void draw_memory(std::mt19937_64& random, AcceleratorConfig& config) {
    ExternalMemorySettings& memory = config.external_memory;
    memory.model = MemoryModel::axi;
    memory.port_bytes = one_of<std::uint64_t>(random, std::array<std::uint64_t, 4>{4, 8, 16, 32});
    memory.burst_bytes = memory.port_bytes << random() % 6;
    memory.outstanding = one_of(random, std::array<std::uint64_t, 4>{1, 2, 4, 16});
    memory.prefetch = random() % 2 == 0;
    memory.ports = 1 + random() % 4;
    memory.request_cycles = one_of(random, std::array<Cycles, 4>{0, 1, 7, 24});
    memory.dram_gb_per_s = one_of(random, std::array<double, 4>{0.3, 2, 19.2, 1e6});
    memory.read_latency_ns = one_of(random, std::array<double, 4>{0, 3.3, 50, 120});
    MemoryPlacement& placement = config.memory_placement;
    for (std::uint64_t* address : {&placement.mesh_address, &placement.image_address, &placement.table_address})
        *address += random() % 300;
}

bool check_seed(std::uint64_t seed, RandomConfigOptions const& options) {
    CAPTURE(seed);
    RandomStimulusOptions stimulus_options;
    stimulus_options.samples = {0, 8};
    stimulus_options.window = {4, 32};
    Stimulus const stimulus = random_stimulus(seed, stimulus_options);
    AcceleratorConfig config = random_config(seed, options);
    adopt(stimulus, config);
    std::mt19937_64 random(seed);
    draw_memory(random, config);
    RunStatistics const lockstep = test_run(config, stimulus, Engine::lockstep).statistics;
    RunStatistics const decoupled = test_run(config, stimulus, Engine::decoupled).statistics;
    CHECK(lockstep.deadlocked() == decoupled.deadlocked());
    CHECK(first_difference(all_cells(decoupled), all_cells(lockstep)) == "");
    CHECK(first_difference(stuck_cells(decoupled), stuck_cells(lockstep)) == "");
    return !decoupled.deadlocked();
}

TEST_CASE("Engines agree about an external memory, seeds 100 to 159", "[memory]") {
    RandomConfigOptions options;
    options.max_lanes = 6;
    options.any_region = true;
    for (std::uint64_t seed = 100; seed < 160; ++seed)
        CHECK(check_seed(seed, options));
}

TEST_CASE("Engines agree about an external memory where FIFOs deadlock", "[memory]") {
    RandomConfigOptions options;
    options.is_deadlock_free = false;
    options.fifo_depth = {1, 3};
    int deadlocks = 0;
    for (std::uint64_t seed = 200; seed < 240; ++seed)
        deadlocks += check_seed(seed, options) ? 0 : 1;
    CHECK(deadlocks > 5);
}

}  // namespace faster::testing::memory_engines_test
