#include "dataflow/lookup/state_table.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "faster/dataflow_names.hpp"

namespace dataflow::timing::state_table_test {

TEST_CASE("Equal states have one number, and stay where they are", "[state_table]") {
    std::mt19937 random(1);
    StateTable table;
    std::vector<StateWords> states;
    std::vector<StateWord const*> places;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        StateWords words(1 + random() % 80, 7);
        words[0] = static_cast<StateWord>(i);
        words[random() % words.size()] ^= static_cast<StateWord>(random());
        words[0] = static_cast<StateWord>(i);
        REQUIRE(table.number_of(words) == i);
        REQUIRE(table.number_of(words) == i);
        states.push_back(words);
        places.push_back(table[i].words);
    }
    CHECK(table.size() == 3000);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        REQUIRE(table.number_of(states[i]) == i);
        REQUIRE(table[i].words == places[i]);
        REQUIRE(StateWords(table[i].words, table[i].words + table[i].size) == states[i]);
    }
    StateWords longer = states[5];
    longer.push_back(0);
    CHECK(table.number_of(longer) == 3000);
}

TEST_CASE("A table of states that is full still knows those it has", "[state_table]") {
    StateTable table(2);
    CHECK(table.number_of(StateWords{1, 2}) == 0);
    CHECK(table.number_of(StateWords{3}) == 1);
    CHECK(table.number_of(StateWords{4}) == StateTable::none);
    CHECK(table.number_of(StateWords{3}) == 1);
    CHECK(table.size() == 2);
}

TEST_CASE("What the words of a state say is what was put there", "[state_table]") {
    ProcessFlags flags;
    flags.loop = 5;
    flags.begun = ProcessFlags::most_begun;
    flags.next_ports = 0xA5;
    flags.frozen = true;
    flags.waits_at = 8;
    flags.left = 12345;
    StateWord words[4] = {};
    CHECK(flags.put(words) == words + ProcessFlags::words);
    ProcessFlags const read = ProcessFlags::of(words);
    CHECK(read.loop == 5);
    CHECK(read.begun == ProcessFlags::most_begun);
    CHECK(read.next_ports == 0xA5);
    CHECK(read.frozen);
    CHECK(read.waits_at == 8);
    CHECK(read.left == 12345);

    FifoCounts counts;
    counts.tokens = 4096;
    counts.tokens_over = 4095;
    counts.room_over = 37;
    CHECK(counts.put(words) == words + FifoCounts::words);
    CHECK(FifoCounts::of(words).tokens == 4096);
    CHECK(FifoCounts::of(words).tokens_over == 4095);
    CHECK(FifoCounts::of(words).room_over == 37);

    CHECK(put_code(0xFEDCBA9876543210U, words) == words + words_of_operation);
    CHECK(code_of(words) == 0xFEDCBA9876543210U);
}

}  // namespace dataflow::timing::state_table_test
