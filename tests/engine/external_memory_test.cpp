#include <catch2/catch.hpp>

#include "support/forked_simulation.hpp"
#include "support/memory_trials.hpp"
#include "support/random_stimulus.hpp"

namespace faster::testing::external_memory_test {

TEST_CASE("Engines and twin agree behind external memory, seeds 20000 to 20039", "[engine_vs_twin][memory]") {
    int const deadlocks = check_memory_seeds(20000, 40);
    CHECK(deadlocks > 2);  // or the mixture tests nothing
    CHECK(deadlocks < 12);
}

TEST_CASE("Recorded runs behind external memory are retimed as they would run, seeds 20000 to 20019",
          "[engine_vs_twin][memory][retime]") {
    CHECK(check_memory_retimings(20000, 20) > 12);
}

TEST_CASE("A memory that nothing limits costs the engines what the page derives", "[memory]") {
    // A window of 4 with a triangle of three fragments, which the only core waits for: docs/memory-model.md, By hand.
    Stimulus stimulus;
    stimulus.width = stimulus.height = 8;
    stimulus.window = 4;
    stimulus.observed_depth = Image<std::uint16_t>(8, 8, 512);
    stimulus.observed_edges = Image<std::uint8_t>(8, 8, 1);
    stimulus.triangles.push_back(TriangleCode{{{16, 16, 1U << 14}, {16, 32, 1U << 14}, {32, 16, 1U << 14}}});
    AcceleratorConfig config;
    config.cores = 1;
    adopt(stimulus, config);
    for (std::size_t const samples : {1U, 2U, 5U})
        for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
            stimulus.samples.assign(samples, SampleInput{2, 2, 0, 1});
            AcceleratorConfig axi = config;
            axi.external_memory.model = MemoryModel::axi;
            Cycles const ideal = run_forked(config, stimulus, engine).statistics.total_cycles;
            Cycles const usual = run_forked(axi, stimulus, engine).statistics.total_cycles;
            axi.external_memory.outstanding = 1000000;
            axi.external_memory.request_cycles = 0;
            axi.external_memory.read_latency_ns = 0;
            axi.external_memory.dram_gb_per_s = 1e6;
            CHECK(run_forked(axi, stimulus, engine).statistics.total_cycles == ideal + (samples == 1 ? 5 : 8));
            if (samples == 1)
                CHECK(usual == ideal + 101);
        }
}

// 21561: an empty mesh on the chip, at an odd address; 21200: a deadlock of a process that had tokens left to read when
// it was last told something; the others: bursts that end with the begin of a token.
TEST_CASE("Engines and twin agree behind external memory where they did not at first", "[engine_vs_twin][memory]") {
    for (std::uint64_t const seed : {21561U, 21444U, 21200U, 30042U, 31230U})
        CHECK(check_memory_seeds(seed, 1) >= 0);
}

}  // namespace faster::testing::external_memory_test
