#include <catch2/catch.hpp>
#include <random>

#include "kernel/sizing/cheapest_choice.hpp"
#include "support/raster_machine.hpp"

namespace faster::sizing {
namespace {

using testing::fifo_count;
using testing::FifoId;

constexpr FifoKind srl = FifoKind::shift_register;
constexpr FifoKind memory = FifoKind::memory;

unsigned token_bits(FifoId fifo, AcceleratorConfig const& config) {
    return testing::raster_machine(config).fifos.at(index_of(fifo)).bits;
}

Primitives primitives(FifoKind kind, std::uint64_t depth, unsigned bits) {
    return primitives_of(kind, depth, bits, CostWeights());
}

double cost(Choice const& choice, std::vector<FifoTokens> const& tokens) {
    return cost_of(sum_of(choice, tokens, CostWeights()), CostWeights());
}

}  // namespace

TEST_CASE("A shift register takes half a LUT per bit up to depth 16, then a LUT per bit and 32 tokens", "[sizing]") {
    CHECK(primitives(srl, 1, 34) == Primitives{17, 0});
    CHECK(primitives(srl, 16, 34) == Primitives{17, 0});
    CHECK(primitives(srl, 16, 1) == Primitives{1, 0});
    CHECK(primitives(srl, 17, 34) == Primitives{34, 0});
    CHECK(primitives(srl, 32, 34) == Primitives{34, 0});
    CHECK(primitives(srl, 33, 34) == Primitives{68, 0});
}

TEST_CASE("A memory takes distributed RAM while that costs less, then block RAM", "[sizing]") {
    CHECK(primitives(memory, 32, 14) == Primitives{7 + 1, 0});  // a slice holds 32 x 14
    CHECK(primitives(memory, 33, 7) == Primitives{7 + 1, 0});   // or 64 x 7
    CHECK(primitives(memory, 64, 34) == Primitives{34 + 5, 0});
    CHECK(primitives(memory, 192, 34) == Primitives{3 * (34 + 5), 0});
    CHECK(primitives(memory, 193, 34) == Primitives{0, 1});  // 156 LUTs are more than half of 300.5
    CHECK(primitives(memory, 512, 36) == Primitives{0, 1});
    CHECK(primitives(memory, 513, 36) == Primitives{0, 2});
    CHECK(primitives(memory, 16384, 1) == Primitives{0, 1});
    CHECK(primitives(memory, 512, 72) == Primitives{0, 2});
    CHECK(primitives_of(memory, 193, 34, {1000}) == Primitives{4 * (34 + 5), 0});
    CHECK(cost_of({10, 3}, {300}) == 460);
}

TEST_CASE("The formats decide how many bits a token has", "[sizing]") {
    AcceleratorConfig config;
    CHECK(token_bits(FifoId::vertex, config) == 48);
    CHECK(token_bits(FifoId::area, config) == 33);
    CHECK(token_bits(FifoId::area_reciprocal, config) == 39);
    CHECK(token_bits(FifoId::command, config) == 2);
    CHECK(token_bits(FifoId::fragment_depth, config) == 48);
    CHECK(token_bits(FifoId::edge_token, config) == 34);
    CHECK(token_bits(FifoId::observed_depth, config) == 11);
    CHECK(token_bits(FifoId::result, config) == 4 * 16 + 32);
    config.inlier_unit.sweep_lanes = 4;
    CHECK(token_bits(FifoId::edge_map, config) == 4);
    CHECK(token_bits(FifoId::observed_depth, config) == 4 * 11);
    config.rasterizer.lanes = 8;
    CHECK(token_bits(FifoId::fragment_depth, config) == 48 + 33);  // and the step of a column
    CHECK(token_bits(FifoId::fragment_index, config) == 32 + 8);
    CHECK(token_bits(FifoId::edge_token, config) == 32 + 8);
    CHECK(token_bits(FifoId::command, config) == 2);
    config.flow = Flow::fpga_grip;
    CHECK(token_bits(FifoId::edge_map, config) == 0);  // not there
    CHECK(token_bits(FifoId::edge_token, config) == 0);
    config = {};
    config.fraction_bits.area_reciprocal = 20;
    config.window = 4;
    CHECK(token_bits(FifoId::area_reciprocal, config) == 29);
    CHECK(token_bits(FifoId::result, config) == 4 * 5 + 32);
}

TEST_CASE("Levels are the deepest choices of each price, for every depth", "[sizing]") {
    for (FifoKind const kind : {FifoKind::automatic, srl, memory})
        for (unsigned const bits : {1U, 2U, 11U, 34U, 48U}) {
            CAPTURE(static_cast<int>(kind), bits);
            std::vector<Level> const levels = levels_of(kind, {bits}, 3000, CostWeights());
            for (std::uint64_t depth = 1; depth <= 3000; ++depth) {
                FifoChoice const choice = choice_of(kind, depth);
                Primitives const needed = primitives(choice.kind, depth, bits);
                auto const holds = [&](Level const& level) {
                    return level.choice.kind == choice.kind && level.choice.depth >= depth &&
                           level.primitives == needed;
                };
                REQUIRE(std::count_if(levels.begin(), levels.end(), holds) == 1);
            }
            auto const costs_less = [](Level const& a, Level const& b) { return a.cost < b.cost; };
            CHECK(std::is_sorted(levels.begin(), levels.end(), costs_less));
        }
}

TEST_CASE("The cheapest choice that escapes all cuts is found", "[sizing]") {
    std::vector<FifoTokens> const tokens(fifo_count, {20});
    for (unsigned seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        constexpr std::size_t free = 4;  // the others have one level
        Levels levels(fifo_count);
        for (std::size_t i = 0; i < fifo_count; ++i)
            levels[i] = levels_of(FifoKind::automatic, tokens[i], i < free ? 100 + random() % 900 : 1, CostWeights());
        std::vector<Cut> cuts(random() % 8);
        for (Cut& cut : cuts)
            for (std::size_t i = 0; i < free; ++i)
                if (random() % 2 == 0)
                    cut.members.push_back({i, random() % 300, random() % 3 == 0});
        double least = -1;
        Choice choice(fifo_count);
        for (std::size_t i = 0; i < fifo_count; ++i)
            choice[i] = levels[i].front().choice;
        for (Level const& a : levels[0])
            for (Level const& b : levels[1])
                for (Level const& c : levels[2])
                    for (Level const& d : levels[3]) {
                        choice[0] = a.choice, choice[1] = b.choice, choice[2] = c.choice, choice[3] = d.choice;
                        auto const escaped = [&choice](Cut const& cut) { return cut.is_escaped(choice); };
                        if (std::all_of(cuts.begin(), cuts.end(), escaped) &&
                            (least < 0 || cost(choice, tokens) < least))
                            least = cost(choice, tokens);
                    }
        auto const found = cheapest_choice(levels, cuts);
        REQUIRE(found.has_value() == (least >= 0));
        if (found)
            CHECK(cost(*found, tokens) == Approx(least));
    }
}

}  // namespace faster::sizing
