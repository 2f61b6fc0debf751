#include "datapath/edge_maps.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace faster::datapath {
namespace {

std::vector<std::uint8_t> bits_of(Bitmap const& map) {
    auto const side = static_cast<std::size_t>(map.side());
    std::vector<std::uint8_t> bits(side * side);
    map.unpack(0, bits.size(), bits.data());
    return bits;
}

int draw(std::mt19937& random, int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); }

}  // namespace

TEST_CASE("Tokens put down together leave what their iterations leave", "[edge_maps]") {
    unsigned const seed = 7;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int const side : {1, 2, 63, 64, 65, 130, 200}) {
        CAPTURE(side);
        EdgeMaps at_once(side);
        EdgeMaps in_two(side);
        for (int burst = 0; burst < 40; ++burst) {
            EdgeMaps::Pen pen(at_once);
            for (int i = 0; i < side * side / 8 + 3; ++i) {
                // Off the window now and then.
                EdgeToken const token{static_cast<std::int16_t>(draw(random, side + 2) - 1),
                                      static_cast<std::int16_t>(draw(random, side + 2) - 1),
                                      draw(random, 3) == 0 ? EdgeTokenKind::Edge : EdgeTokenKind::Object};
                in_two.take(token);
                if (in_two.needs_second(token))
                    in_two.take_second(token);
                CHECK(pen.take(token) == (in_two.needs_second(token) ? 1 : 0));
            }
        }
        CHECK(bits_of(at_once.edge()) == bits_of(in_two.edge()));
        CHECK(bits_of(at_once.object()) == bits_of(in_two.object()));
    }
}

}  // namespace faster::datapath
