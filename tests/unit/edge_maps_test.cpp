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

TEST_CASE("A run of object pixels leaves what its pixels leave one by one", "[edge_maps]") {
    unsigned const seed = 7;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int const side : {1, 2, 63, 64, 65, 130, 200}) {
        CAPTURE(side);
        EdgeMaps by_run(side);
        EdgeMaps by_pixel(side);
        for (int i = 0; i < 400; ++i) {
            auto const row = static_cast<std::int16_t>(draw(random, side));
            int const from = draw(random, side);
            int const to = from + draw(random, side - from);
            for (int col = from; col <= to; ++col) {
                EdgeToken const token{row, static_cast<std::int16_t>(col), EdgeTokenKind::Object};
                by_pixel.take(token);
                by_pixel.take_second(token);
            }
            by_run.take_run(row, from, to);
        }
        CHECK(bits_of(by_run.edge()) == bits_of(by_pixel.edge()));
        CHECK(bits_of(by_run.object()) == bits_of(by_pixel.object()));
    }
}

}  // namespace faster::datapath
