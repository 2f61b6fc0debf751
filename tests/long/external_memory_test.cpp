#include <catch2/catch.hpp>

#include "support/memory_trials.hpp"

namespace faster::testing {

TEST_CASE("Engines and twin agree behind external memory, seeds 21000 to 21299", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(21000, 300) > 20);
}

TEST_CASE("Engines and twin agree behind external memory, seeds 21300 to 21599", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(21300, 300) > 20);
}

}  // namespace faster::testing
