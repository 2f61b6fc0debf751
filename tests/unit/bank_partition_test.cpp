#include "dataflow/core/machine/bank_partition.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "faster/dataflow_names.hpp"

namespace faster::bank_partition_test {

constexpr PartitionType cyclic = PartitionType::cyclic;
constexpr PartitionType block = PartitionType::block;

AccessPattern const cross{{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}, {}};
AccessPattern const read_and_write{{{0, 0}}, {{0, 0}}};

std::uint64_t crowd(AccessPattern const& pattern, PartitionConfig const& config, int side = 200) {
    return BankPartition(config, side).accesses_per_bank(pattern);
}

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
                            found[static_cast<std::size_t>(at.row) * side + static_cast<std::size_t>(at.col)] +=
                                partition.bank_of(at.row, at.col) == bank ? 1 : 0;
                CHECK(std::count(found.begin(), found.end(), 1) == side * side);
                CHECK(*std::max_element(words.begin(), words.end()) == partition.bank_words());
            }
    CHECK(BankPartition({cyclic, 3, 0}, side).banks() == 9);
    CHECK(BankPartition({cyclic, 3, 0}, side).bank_words() == 16);
    CHECK(BankPartition({block, 3, 2}, side).banks() == 3);
    CHECK(BankPartition({block, 3, 2}, side).bank_words() == 40);
}

}  // namespace faster::bank_partition_test
