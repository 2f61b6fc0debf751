#include "kernel/base/write_distances.hpp"

#include <catch2/catch.hpp>

#include "kernel/machine/dependence.hpp"

namespace faster::write_distances_test {

using Counts = std::vector<std::uint64_t>;

TEST_CASE("Distances are counted from the last iteration that wrote the word", "[hazards]") {
    WriteDistances distances(8, 4);
    distances.enter();
    distances.next_iteration();
    distances.write(5);
    distances.next_iteration();
    distances.read(5);  // 1
    distances.next_iteration();
    distances.read(6);
    distances.write(5);  // 2
    distances.next_iteration();
    distances.next_iteration();
    distances.next_iteration();
    distances.read(5);  // 3, and no more than 4 of the first
    distances.next_iteration();
    distances.read(5);  // 4 is not below 4
    CHECK(distances.smallest() == 1);
    CHECK(distances.counts() == Counts{0, 1, 1, 1});
}

TEST_CASE("An iteration counts once for a word that it reads and writes, and never for what it wrote itself",
          "[hazards]") {
    WriteDistances distances(2, 3);
    distances.enter();
    for (int i = 0; i < 3; ++i) {
        distances.next_iteration();
        distances.read(1);
        distances.overwrite(1);
        distances.read(1);
    }
    CHECK(distances.counts() == Counts{0, 2, 0});
}

TEST_CASE("What an earlier entry wrote is in the memory", "[hazards]") {
    WriteDistances distances(2, 3);
    for (int entry = 0; entry < 3; ++entry) {
        distances.enter();
        distances.next_iteration();
        distances.read(0);
        distances.overwrite(0);
    }
    CHECK(distances.smallest() == 0);
    CHECK(distances.counts() == Counts{0, 0, 0});
}

TEST_CASE("A word is stale up to the cycle in which it is written, the cycle included", "[hazards]") {
    MachineDependence dependence;
    dependence.read_stage = 7;
    dependence.write_stage = 9;
    dependence.reads = 1;
    dependence.writes = 1;
    CHECK(dependence.span() == 3);
    CHECK(dependence.is_hazard(1, 1));
    CHECK(dependence.is_hazard(2, 1));
    CHECK_FALSE(dependence.is_hazard(3, 1));
    CHECK(dependence.is_hazard(1, 2));
    CHECK_FALSE(dependence.is_hazard(2, 2));
    CHECK_FALSE(dependence.is_hazard(1, 3));
    CHECK(dependence.reach(1) == 2);
    CHECK(dependence.reach(2) == 1);
    CHECK(dependence.reach(3) == 0);
    dependence.reads = 0;
    CHECK_FALSE(dependence.is_hazard(1, 1));
    CHECK(dependence.reach(1) == 0);
}

}  // namespace faster::write_distances_test
