#include <catch2/catch.hpp>

#include "support/memory_trials.hpp"

namespace faster::testing {

TEST_CASE("Engines and twin agree behind external memory, seeds 20000 to 20039", "[engine_vs_twin][memory]") {
    int const deadlocks = check_memory_seeds(20000, 40);
    CHECK(deadlocks > 2);  // or the mixture tests nothing
    CHECK(deadlocks < 12);
}

TEST_CASE("Recorded runs behind external memory are retimed as they would run, seeds 20000 to 20019",
          "[engine_vs_twin][memory][retime]") {
    CHECK(check_memory_retimings(20000, 20) > 12);
}

// 21561: an empty mesh on the chip, at an odd address; the others: bursts that end with the begin of a token.
TEST_CASE("Engines and twin agree behind external memory where they did not at first", "[engine_vs_twin][memory]") {
    for (std::uint64_t const seed : {21561U, 21444U, 30042U, 31230U})
        CHECK(check_memory_seeds(seed, 1) >= 0);
}

}  // namespace faster::testing
