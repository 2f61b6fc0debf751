#include "dataflow/lookup/numbered_transitions.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <utility>

#include "faster/dataflow_names.hpp"

namespace dataflow::timing::numbered_transitions_test {

constexpr NumberedTransitions::Number numbers = NumberedTransitions::numbers;

NumberedTransitions::Known find(NumberedTransitions const& table, NumberedTransitions::Number state,
                                NumberedTransitions::Number phrase) {
    return NumberedTransitions::Reader(table).find(state, phrase);
}

/// The state and the phrase that have that hash, of 36 bits, of which the upper ones are the place.
std::pair<std::uint32_t, std::uint32_t> key_with(std::uint64_t hash) {
    constexpr std::uint64_t hashes = std::uint64_t{numbers} * numbers, factor = 0x9E3779B97;
    std::uint64_t inverse = 1;  // by Newton's method
    for (int i = 0; i < 6; ++i)
        inverse *= 2 - factor * inverse;
    std::uint64_t const key = hash * inverse % hashes;
    return {static_cast<std::uint32_t>(key / numbers), static_cast<std::uint32_t>(key % numbers)};
}

TEST_CASE("Numbered transitions are found as they were added, and no others", "[numbered_transitions]") {
    // From few numbers, most of which come together, to all there are.
    auto const most = GENERATE(std::uint32_t{300}, std::uint32_t{5000}, numbers);
    std::mt19937 random(most);
    auto const below = [&random](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    NumberedTransitions table;
    std::map<std::pair<std::uint32_t, std::uint32_t>, NumberedTransitions::Known> added;
    for (int i = 0; i < 60000; ++i) {
        std::uint32_t const state = below(most), phrase = below(most);
        NumberedTransitions::Known const known = {below(numbers), below(numbers)};
        if (added.emplace(std::pair(state, phrase), known).second)
            table.add(state, phrase, known);
    }
    for (auto const& [key, known] : added) {
        NumberedTransitions::Known const found = find(table, key.first, key.second);
        REQUIRE(found);
        REQUIRE(found.next == known.next);
        REQUIRE(found.number == known.number);
    }
    for (int i = 0; i < 60000; ++i) {
        std::uint32_t const state = below(numbers), phrase = below(numbers);
        REQUIRE(static_cast<bool>(find(table, state, phrase)) == (added.count({state, phrase}) > 0));
    }
}

TEST_CASE("Numbered transitions hold dense rows of states and of phrases", "[numbered_transitions]") {
    NumberedTransitions table;
    for (std::uint32_t i = 0; i < numbers; i += 3) {
        table.add(7, i, {i, i});
        table.add(i, 8, {i, numbers - 1 - i});
    }
    for (std::uint32_t i = 0; i < numbers; ++i) {
        REQUIRE(find(table, 7, i).number == (i % 3 == 0 ? i : NumberedTransitions::Known::none));
        REQUIRE(find(table, i, 8).number == (i % 3 == 0 ? numbers - 1 - i : NumberedTransitions::Known::none));
    }
}

TEST_CASE("Numbered transitions whose hashes are alike are told from each other", "[numbered_transitions]") {
    // So many hashes apart: of 8192 places, hundreds are for the same few, far more than may be behind them.
    auto const apart = GENERATE(std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{1} << 10, std::uint64_t{1} << 20);
    NumberedTransitions table;
    auto const key_at = [apart](std::uint64_t i) { return key_with(i * apart - 1000 * apart); };
    for (std::uint32_t i = 0; i < 2000; ++i)
        if (i % 3 != 0)
            table.add(key_at(i).first, key_at(i).second, {i, numbers - 1});
    std::uint64_t found = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        NumberedTransitions::Known const known = find(table, key_at(i).first, key_at(i).second);
        if (!known)
            continue;  // forgotten: too many of them
        ++found;
        REQUIRE(i % 3 != 0);
        REQUIRE(known.next == i);
        REQUIRE(known.number == numbers - 1);
    }
    CHECK(found > 0);
}

TEST_CASE("A look-up for what is not there ends behind a long row of others", "[numbered_transitions]") {
    constexpr std::uint64_t a_place = 1U << 23, first = 100 * a_place;
    NumberedTransitions table;
    auto const add = [&table](std::uint64_t hash) { table.add(key_with(hash).first, key_with(hash).second, {1, 2}); };
    auto const is_known = [&table](std::uint64_t hash) {
        return static_cast<bool>(find(table, key_with(hash).first, key_with(hash).second));
    };
    for (std::uint64_t tag = 0; tag < 31; ++tag)
        add(first + tag);
    CHECK(is_known(first + 30));
    for (std::uint64_t tag = 31; tag < a_place; tag += tag < 1000 ? 1 : 1023)
        REQUIRE_FALSE(is_known(first + tag));
    CHECK_FALSE(is_known(first + a_place - 1));  // the free slot behind them looks like it
    for (std::uint64_t place = 31; place < 40; ++place)
        add(first + place * a_place + 1000);
    for (std::uint64_t tag = 31; tag < 2000; ++tag)
        REQUIRE_FALSE(is_known(first + tag));  // one of them looks like one so far behind
}

}  // namespace dataflow::timing::numbered_transitions_test
