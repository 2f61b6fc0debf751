#include "dataflow/base/device/block_ram.hpp"

#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"

namespace faster::block_ram_test {

double count_of(std::uint64_t words, std::uint64_t bits, std::uint64_t ports = 2, std::uint64_t partition = 1) {
    return ramb36_count({words, bits, ports, partition});
}

TEST_CASE("A memory takes the shape of primitive that needs fewest", "[block_ram]") {
    CHECK(count_of(32768, 1) == 1);
    CHECK(count_of(32769, 1) == 2);
    CHECK(count_of(40000, 2) == 3);    // 16K x 2 three times, not 32K x 1 twice two times
    CHECK(count_of(40000, 11) == 15);  // 8K x 4 five times three times; 4K x 9 would take 10 x 2
    CHECK(count_of(1024, 36) == 1);
    CHECK(count_of(1024, 37) == 2);
    CHECK(count_of(4096, 9) == 1);
}

TEST_CASE("What fits a RAMB18 is half a RAMB36", "[block_ram]") {
    CHECK(count_of(16384, 1) == 0.5);
    CHECK(count_of(16385, 1) == 1);
    CHECK(count_of(1024, 18) == 0.5);
    CHECK(count_of(1, 1) == 0.5);
}

TEST_CASE("More ports than the banks have take copies, and banks take at least one primitive each", "[block_ram]") {
    CHECK(count_of(40000, 11, 1) == 15);
    CHECK(count_of(40000, 11, 3) == 30);
    CHECK(count_of(40000, 11, 5) == 45);
    CHECK(count_of(40000, 11, 6, 3) == 3 * 6);  // 13,334 x 11: 16K x 2 six times
    CHECK(count_of(40000, 11, 7, 3) == 2 * 3 * 6);
    CHECK(count_of(40000, 1, 2, 3) == 3 * 0.5);  // 13,334 x 1
}

}  // namespace faster::block_ram_test
