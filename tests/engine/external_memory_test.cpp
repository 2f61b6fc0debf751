#include <catch2/catch.hpp>

#include "support/memory_trials.hpp"

namespace faster::testing {

TEST_CASE("Engines and twin agree behind external memory, seeds 20000 to 20039", "[engine_vs_twin][memory]") {
    int const deadlocks = check_memory_seeds(20000, 40);
    CHECK(deadlocks > 2);  // or the mixture tests nothing
    CHECK(deadlocks < 12);
}

}  // namespace faster::testing
