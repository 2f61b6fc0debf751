#include "kernel/machine/bank_partition.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "faster/block_ram.hpp"
#include "faster/loop_accesses.hpp"

namespace faster {
namespace {

constexpr PartitionType cyclic = PartitionType::cyclic;
constexpr PartitionType block = PartitionType::block;

AccessPattern const cross{{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}, {}};
AccessPattern const read_and_write{{{0, 0}}, {{0, 0}}};

std::uint64_t crowd(AccessPattern const& pattern, PartitionConfig const& config, int side = 200) {
    return BankPartition(config, side).accesses_per_bank(pattern);
}

}  // namespace

TEST_CASE("Cyclic banks part neighbours, blocks do not", "[partition]") {
    CHECK(crowd(cross, {}) == 5);
    CHECK(crowd(cross, {cyclic, 2, 0}) == 2);  // above and below, left and right, the pixel
    CHECK(crowd(cross, {cyclic, 3, 0}) == 1);
    CHECK(crowd(cross, {cyclic, 3, 1}) == 3);  // the row
    CHECK(crowd(cross, {cyclic, 3, 2}) == 3);  // the column
    CHECK(crowd(cross, {cyclic, 2, 1}) == 3);
    CHECK(crowd(cross, {block, 4, 0}) == 5);
    CHECK(crowd(cross, {block, 200, 1}) == 3);  // a row is a block
    CHECK(crowd(cross, {block, 100, 2}) == 4);  // two columns are
    CHECK(crowd(cross, {cyclic, 1, 0}) == 5);
    CHECK(crowd(cross, {block, 1, 0}) == 5);
}

TEST_CASE("A word read and written is two accesses of one bank", "[partition]") {
    CHECK(crowd(read_and_write, {cyclic, 8, 0}) == 2);
    CHECK(crowd(read_and_write, {block, 8, 0}) == 2);
}

TEST_CASE("Lanes touch common neighbours once", "[partition]") {
    CHECK(widened(cross, 1).accesses() == 5);
    CHECK(widened(cross, 2).accesses() == 8);
    CHECK(widened(cross, 4).accesses() == 14);
    CHECK(widened(read_and_write, 4).accesses() == 8);
    CHECK(crowd(widened(cross, 4), {cyclic, 4, 2}) == 4);  // a column of three, and a neighbour of the row
    CHECK(crowd(widened(cross, 4), {cyclic, 6, 2}) == 3);  // six columns, six banks
    CHECK(crowd(widened(read_and_write, 4), {cyclic, 4, 2}) == 2);
    CHECK(crowd(widened(read_and_write, 4), {cyclic, 3, 2}) == 4);
    CHECK(crowd(widened(read_and_write, 4), {block, 100, 2}) == 4);  // two of two columns
}

TEST_CASE("Every word has a bank, and none has more than bank_words", "[partition]") {
    constexpr int side = 10;
    for (PartitionType const type : {PartitionType::none, cyclic, block})
        for (std::uint64_t const factor : {1U, 2U, 3U, 4U, 10U})
            for (std::uint64_t const dimension : {0U, 1U, 2U}) {
                CAPTURE(static_cast<int>(type), factor, dimension);
                BankPartition const partition({type, factor, dimension}, side);
                std::vector<std::uint64_t> words(partition.banks());
                std::vector<int> found(std::size_t{side} * side);  // how often, as a word of its bank
                for (int row = 0; row < side; ++row)
                    for (int col = 0; col < side; ++col)
                        ++words.at(partition.bank_of(row, col));
                for (std::uint64_t bank = 0; bank < partition.banks(); ++bank)
                    for (std::uint64_t i = 0; i < partition.bank_words(); ++i)
                        if (PixelOffset const at = partition.word_of(bank, i); at.row < side && at.col < side)
                            found[static_cast<std::size_t>(at.row * side + at.col)] +=
                                partition.bank_of(at.row, at.col) == bank ? 1 : 0;
                CHECK(std::count(found.begin(), found.end(), 1) == side * side);
                CHECK(*std::max_element(words.begin(), words.end()) == partition.bank_words());
            }
    CHECK(BankPartition({cyclic, 3, 0}, side).banks() == 9);
    CHECK(BankPartition({cyclic, 3, 0}, side).bank_words() == 16);
    CHECK(BankPartition({block, 3, 2}, side).banks() == 3);
    CHECK(BankPartition({block, 3, 2}, side).bank_words() == 40);
}

TEST_CASE("Loops know where they touch their memories", "[partition]") {
    AcceleratorConfig config;
    auto const crowd_of = [&config](LoopId loop, std::size_t memory, PartitionConfig const& partition) {
        return crowd(loop_accesses(loop, config).at(memory).pattern, partition);
    };
    CHECK(crowd_of(LoopId::sweep, 0, {cyclic, 3, 0}) == 1);
    config.inlier_unit.clearing = MapClearing::on_read_out;
    CHECK(crowd_of(LoopId::sweep, 0, {}) == 6);
    CHECK(crowd_of(LoopId::sweep, 0, {cyclic, 3, 0}) == 1);  // above to the left is a ninth bank
    CHECK(crowd_of(LoopId::sweep, 0, {cyclic, 2, 0}) == 2);
    config.inlier_unit.neighbour_access = NeighbourAccess::window;
    CHECK(crowd_of(LoopId::sweep, 0, {cyclic, 4, 0}) == 2);  // the word it has read
    CHECK(crowd_of(LoopId::fragment, 0, {cyclic, 4, 0}) == 2);
    CHECK(crowd_of(LoopId::token, 1, {cyclic, 2, 1}) == 2);  // above and below are both odd
    CHECK(crowd_of(LoopId::token, 1, {cyclic, 3, 1}) == 1);
    config.edge_map.algorithm = EdgeMapAlgorithm::bounded;
    CHECK(crowd_of(LoopId::token, 0, {}) == 5);
    CHECK(crowd_of(LoopId::token, 0, {cyclic, 3, 1}) == 2);
    CHECK(crowd_of(LoopId::token, 0, {cyclic, 3, 2}) == 5);
    CHECK(loop_accesses(LoopId::token, config).size() == 1);
    CHECK(loop_accesses(LoopId::scan, config).empty());
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
    BramConfig& bram = config.bram(BramId::depth_buffer);
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 15);
    bram.partition = {cyclic, 2, 0};  // 10,000 x 11: 2K x 18 five times
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 4 * 5);
    bram.partition = {cyclic, 3, 2};  // 200 x 67 x 11
    CHECK(memory_shape(BramId::depth_buffer, config).bank_words == 13400);
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 3 * 6);
    bram.ports = 3;  // of each bank: two copies
    CHECK(ramb36_count(memory_shape(BramId::depth_buffer, config)) == 2 * 3 * 6);
}

}  // namespace faster
