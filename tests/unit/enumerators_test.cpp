#include "dataflow/base/enumerators.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <string_view>
#include <utility>

#include "faster/config/edge_map_algorithm.hpp"

namespace faster::enumerators_test {

enum class Colour { red, green, blue };
enum class Single { one };
struct Outer {
    enum class Inner { one, two_words };
};
using Row = std::pair<Colour, int>;

constexpr Colour colour_of(Row const& row) { return row.first; }

TEST_CASE("A table indexed by an enumeration is known to be short", "[unit]") {
    STATIC_REQUIRE(enum_size<Colour>() == 3);
    STATIC_REQUIRE(enum_size<Single>() == 1);
    constexpr std::array whole{Row{Colour::red, 1}, Row{Colour::green, 2}, Row{Colour::blue, 3}};
    constexpr std::array short_of_one{Row{Colour::red, 1}, Row{Colour::green, 2}};
    constexpr std::array in_another_order{Row{Colour::green, 1}, Row{Colour::red, 2}, Row{Colour::blue, 3}};
    STATIC_REQUIRE(has_a_row_for_each<Colour>(whole, colour_of));
    STATIC_REQUIRE_FALSE(has_a_row_for_each<Colour>(short_of_one, colour_of));
    STATIC_REQUIRE_FALSE(has_a_row_for_each<Colour>(in_another_order, colour_of));
}

TEST_CASE("Enumerators are written as they are called", "[unit]") {
    CHECK(enumerator_names<Colour> == std::array<std::string_view, 3>{"red", "green", "blue"});
    CHECK(enumerator_name(Outer::Inner::two_words) == "two_words");
}

TEST_CASE("Every edge map algorithm says what its loops access", "[unit]") {
    for (EdgeMapDesign const& design : edge_map_designs) {
        CAPTURE(enumerator_name(design.algorithm));
        PerMap const all{design.edge_token.edge_map | design.object_token.edge_map | design.second.edge_map,
                         design.edge_token.object_map | design.object_token.object_map | design.second.object_map};
        CHECK((design.bits.edge_map > 0) == (design.clear.edge_map > 0));
        CHECK((design.bits.object_map > 0) == (design.clear.object_map > 0));
        CHECK((design.bits.edge_map > 0) == (all.edge_map > 0));
        CHECK((design.bits.object_map > 0) == (all.object_map > 0));
    }
}

}  // namespace faster::enumerators_test
