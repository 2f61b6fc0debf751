#include "faster/block_ram.hpp"

#include <catch2/catch.hpp>
#include <utility>

namespace faster {
namespace {

double count_of(std::uint64_t words, std::uint64_t bits, std::uint64_t ports = 2, std::uint64_t partition = 1) {
    return ramb36_count({words, bits, ports, partition});
}

}  // namespace

TEST_CASE("The two maps of ten cores are the 40 block RAMs of Table 6.2", "[block_ram]") {
    AcceleratorConfig const config;
    double const per_core =
        ramb36_count(memory_shape(BramId::edge_map, config)) + ramb36_count(memory_shape(BramId::object_map, config));
    CHECK(per_core * static_cast<double>(config.raster_cores) == 414 - 374);
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

TEST_CASE("Memories follow the edge map algorithm and the window", "[block_ram]") {
    AcceleratorConfig config;
    auto const counts = [&config](EdgeMapAlgorithm algorithm) {
        config.edge_map.algorithm = algorithm;
        return std::pair{ramb36_count(memory_shape(BramId::edge_map, config)),
                         ramb36_count(memory_shape(BramId::object_map, config))};
    };
    CHECK(counts(EdgeMapAlgorithm::bounded) == std::pair{3.0, 0.0});
    CHECK(counts(EdgeMapAlgorithm::dual_map_4_1_2) == std::pair{2.0, 2.0});
    CHECK(counts(EdgeMapAlgorithm::inner_border) == std::pair{0.0, 2.0});
    config.window = 100;
    CHECK(counts(EdgeMapAlgorithm::dual_map) == std::pair{0.5, 0.5});
    CHECK(memory_shape(BramId::depth_buffer, config).words == 10000);
}

TEST_CASE("Two buffers take twice the block RAMs", "[block_ram]") {
    AcceleratorConfig config;
    auto const counts = [&config] {
        std::vector<double> all;
        for (BramId const id : {BramId::edge_map, BramId::object_map, BramId::depth_buffer})
            all.push_back(ramb36_count(memory_shape(id, config)));
        return all;
    };
    CHECK(counts() == std::vector<double>{2, 2, 15});
    config.edge_map.buffers = 2;
    CHECK(counts() == std::vector<double>{4, 4, 15});
    config.inlier_unit.buffers = 2;
    config.bram(BramId::depth_buffer).partition = {PartitionType::cyclic, 20, 2};
    CHECK(counts() == std::vector<double>{4, 4, 40});
    CHECK(memory_shape(BramId::depth_buffer, config).words == 40000);  // of each
}

}  // namespace faster
