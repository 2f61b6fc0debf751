#include "modules/edge_map_builder/algorithms/edge_maps.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace faster::datapath::edge_maps_test {

std::vector<std::uint8_t> copy_of(std::uint8_t const* map, int side) { return {map, map + side * side}; }

int draw(std::mt19937& random, int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); }

TEST_CASE("Marked tokens leave what their iterations leave", "[edge_maps]") {
    unsigned const seed = 7;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int const side : {1, 2, 63, 64, 65, 130, 200}) {
        CAPTURE(side);
        EdgeMaps at_once(side);
        EdgeMaps in_two(side);
        for (int burst = 0; burst < 40; ++burst) {
            for (int i = 0; i < side * side / 8 + 3; ++i) {
                // Off the window now and then.
                EdgeToken const token{static_cast<std::int16_t>(draw(random, side + 2) - 1),
                                      static_cast<std::int16_t>(draw(random, side + 2) - 1),
                                      draw(random, 3) == 0 ? EdgeTokenKind::Edge : EdgeTokenKind::Object};
                in_two.take(token);
                if (in_two.needs_second(token))
                    in_two.take_second(token);
                CHECK(at_once.mark(token) == (in_two.needs_second(token) ? 1 : 0));
            }
        }
        at_once.settle();
        CHECK(copy_of(at_once.edge(), side) == copy_of(in_two.edge(), side));
        CHECK(copy_of(at_once.object(), side) == copy_of(in_two.object(), side));
    }
}

}  // namespace faster::datapath::edge_maps_test
