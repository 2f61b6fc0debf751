#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/memory_trials.hpp"

namespace faster::testing::external_memory_test {

TEST_CASE("Engines and twin agree behind external memory, seeds 21000 to 21599", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(21000, 600) > 20);
}

// 30042, 30444, 31062, 31230: bursts that end with the begin of a token; 32701, 32958: an empty mesh on the chip.
TEST_CASE("Engines and twin agree behind external memory, seeds 30000 to 31499", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(30000, 1500) > 50);
}

TEST_CASE("Engines and twin agree behind external memory, seeds 31500 to 32999", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(31500, 1500) > 50);
}

TEST_CASE("Engines and twin agree behind external memory, large windows", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(first_with_large_windows, 300) > 10);
}

TEST_CASE("Recorded runs behind external memory are retimed as they would run, seeds 21000 to 21599",
          "[engine_vs_twin][memory][retime]") {
    CHECK(check_memory_retimings(21000, 600) > 400);
}

}  // namespace faster::testing::external_memory_test
