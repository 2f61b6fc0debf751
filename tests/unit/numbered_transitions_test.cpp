#include "timing/numbered_transitions.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <utility>

namespace faster::timing {

namespace {
constexpr NumberedTransitions::Number numbers = 1U << 18;

NumberedTransitions::Known find(NumberedTransitions const& table, NumberedTransitions::Number state,
                                NumberedTransitions::Number phrase) {
    return NumberedTransitions::Reader(table).find(state, phrase);
}
}  // namespace

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

TEST_CASE("Numbers that no slot can tell are not remembered, nor taken for others", "[numbered_transitions]") {
    NumberedTransitions table;
    table.add(1, 0, {2, 3});
    table.add(numbers, 1, {2, 3});
    table.add(4, numbers, {2, 3});
    table.add(5, 1, {numbers, 3});
    table.add(6, 1, {2, numbers});
    CHECK(find(table, 1, 0));
    CHECK_FALSE(find(table, 0, numbers));  // the same bits
    CHECK_FALSE(find(table, numbers, 1));
    CHECK_FALSE(find(table, 0, 1));
    CHECK_FALSE(find(table, 4, numbers));
    CHECK_FALSE(find(table, 5, 1));
    CHECK_FALSE(find(table, 6, 1));
}

}  // namespace faster::timing
