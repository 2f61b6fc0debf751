#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/device/block_ram.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/inlier_unit/inlier_unit.hpp"
#include "support/raster_machine.hpp"

// The memories of a raster core, and what its loops do to them.

namespace faster::testing::core_memories_test {

constexpr PartitionType cyclic = PartitionType::cyclic;

std::vector<MemoryAccess> loop_accesses(LoopId id, AcceleratorConfig const& config) {
    for (ModuleDescription const& module : describe_raster_core(config).modules)
        for (LoopDescription const& loop : module.loops)
            if (module.name == id.module.name && loop.name == id.name)
                return loop.accesses;
    throw std::runtime_error(std::string("no loop ") + id.keys);
}

std::uint64_t crowd(AccessPattern const& pattern, PartitionConfig const& config, int side = 200) {
    return BankPartition(config, side).accesses_per_bank(pattern);
}

/// Of the branch of a loop that asks most of a bank.
std::uint64_t largest_crowd(std::vector<MemoryAccess> const& branches, std::string const& memory,
                            PartitionConfig const& partition) {
    std::uint64_t largest = 0;
    for (MemoryAccess const& branch : branches)
        if (branch.memory == memory)
            largest = std::max(largest, crowd(branch.pattern, partition));
    return largest;
}

TEST_CASE("The two maps of ten cores are the 40 block RAMs of Table 6.2", "[block_ram]") {
    AcceleratorConfig const config;
    double const per_core =
        ramb36_count(memory_shape(BramId::edge_map, config)) + ramb36_count(memory_shape(BramId::object_map, config));
    CHECK(per_core * static_cast<double>(config.cores) == 414 - 374);
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
        for (BramId const id : bram_ids)
            all.push_back(ramb36_count(memory_shape(id, config)));
        return all;
    };
    CHECK(counts() == std::vector<double>{2, 2, 15});
    config.edge_map.buffers = 2;
    CHECK(counts() == std::vector<double>{4, 4, 15});
    config.inlier_unit.buffers = 2;
    config.memory(BramId::depth_buffer).partition = {PartitionType::cyclic, 20, 2};
    CHECK(counts() == std::vector<double>{4, 4, 40});
    CHECK(memory_shape(BramId::depth_buffer, config).words == 40000);  // of each
}

TEST_CASE("Loops know where they touch their memories", "[partition]") {
    AcceleratorConfig config;
    auto const crowd_of = [&config](LoopId loop, char const* memory, PartitionConfig const& partition) {
        return largest_crowd(loop_accesses(loop, config), memory, partition);
    };
    CHECK(crowd_of(LoopId::sweep, "depth_buffer", {cyclic, 3, 0}) == 1);
    config.inlier_unit.clearing = MapClearing::on_read_out;
    CHECK(crowd_of(LoopId::sweep, "depth_buffer", {}) == 6);
    CHECK(crowd_of(LoopId::sweep, "depth_buffer", {cyclic, 3, 0}) == 1);  // above to the left is a ninth bank
    CHECK(crowd_of(LoopId::sweep, "depth_buffer", {cyclic, 2, 0}) == 2);
    config.inlier_unit.neighbour_access = NeighbourAccess::window;
    CHECK(crowd_of(LoopId::sweep, "depth_buffer", {cyclic, 4, 0}) == 2);  // the word it has read
    CHECK(crowd_of(LoopId::fragment, "depth_buffer", {cyclic, 4, 0}) == 2);
    CHECK(crowd_of(LoopId::token, "object_map", {cyclic, 2, 1}) == 2);  // above and below are both odd
    CHECK(crowd_of(LoopId::token, "object_map", {cyclic, 3, 1}) == 1);
    config.edge_map.algorithm = EdgeMapAlgorithm::bounded;
    CHECK(crowd_of(LoopId::token, "edge_map", {}) == 5);
    CHECK(crowd_of(LoopId::token, "edge_map", {cyclic, 3, 1}) == 2);
    CHECK(crowd_of(LoopId::token, "edge_map", {cyclic, 3, 2}) == 5);
    CHECK(crowd_of(LoopId::token, "object_map", {}) == 0);    // it has one map
    CHECK(loop_accesses(LoopId::token, config).size() == 2);  // of an edge token, and of an object token
    CHECK(loop_accesses(LoopId::scan, config).empty());
}

TEST_CASE("With the defaults the sweep and the fragments access what the thesis's inlier unit says", "[partition]") {
    AcceleratorConfig const config;
    for (LoopDescription const& loop : InlierUnit::describe(config).loops) {
        CAPTURE(loop.name);
        std::vector<MemoryAccess> const varied = loop_accesses(loop.name == "sweep"   ? LoopId::sweep
                                                               : loop.name == "clear" ? LoopId::depth_clear
                                                                                      : LoopId::fragment,
                                                               config);
        REQUIRE(varied.size() == 1);
        REQUIRE(loop.accesses.size() == 1);
        CHECK(varied[0].pattern.reads == loop.accesses[0].pattern.reads);
        CHECK(varied[0].pattern.writes == loop.accesses[0].pattern.writes);
    }
}

TEST_CASE("Lanes of the scan touch a word each of the maps they draw in", "[partition][lanes]") {
    AcceleratorConfig config;
    config.edge_map.algorithm = EdgeMapAlgorithm::inner_border;
    config.rasterizer.lanes = 4;
    auto const crowd_of = [&config](LoopId loop, PartitionConfig const& partition) {
        return crowd(loop_accesses(loop, config).at(0).pattern, partition);
    };
    CHECK(crowd_of(LoopId::fragment, {}) == 8);
    CHECK(crowd_of(LoopId::fragment, {cyclic, 2, 2}) == 4);
    CHECK(crowd_of(LoopId::fragment, {cyclic, 4, 2}) == 2);
    CHECK(crowd_of(LoopId::fragment, {cyclic, 4, 1}) == 8);
    CHECK(crowd_of(LoopId::token, {}) == 4);
    CHECK(crowd_of(LoopId::token, {cyclic, 3, 2}) == 2);
    CHECK(crowd_of(LoopId::token, {cyclic, 4, 2}) == 1);
    CHECK(crowd_of(LoopId::sweep, {}) == 1);  // has lanes of its own
}

TEST_CASE("A split memory takes the primitives of its banks", "[partition][block_ram]") {
    AcceleratorConfig config;
    MemorySettings& bram = config.memory(BramId::depth_buffer);
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 15);
    bram.partition = {cyclic, 2, 0};  // 10,000 x 11: 2K x 18 five times
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 4 * 5);
    bram.partition = {cyclic, 3, 2};  // 200 x 67 x 11
    CHECK(memory_shape(BramId::depth_buffer, config).bank_words == 13400);
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 3 * 6);
    bram.ports = 3;  // of each bank: two copies
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 2 * 3 * 6);
}

}  // namespace faster::testing::core_memories_test
