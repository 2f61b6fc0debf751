#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <tuple>

#include "dataflow/run/config/load_config.hpp"
#include "dataflow/tools/sizing/cheapest_choice.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/token_bits.hpp"

namespace dataflow::sizing::fifo_cost_test {
using namespace faster;

using faster::testing::fifo_count;
using faster::testing::FifoId;

constexpr FifoKind srl = FifoKind::shift_register;
constexpr FifoKind memory = FifoKind::memory;

unsigned bits_of(FifoId fifo, AcceleratorConfig const& config) {
    return faster::testing::raster_machine(config).fifos.at(index_of(fifo)).bits;
}

constexpr std::array<FifoGeneration, 3> generations{FifoGeneration::spec, FifoGeneration::vivado_hls,
                                                    FifoGeneration::vitis_hls};

Primitives primitives(FifoKind kind, std::uint64_t depth, unsigned bits) {
    return primitives_of(kind, depth, bits, CostWeights());
}

double cost(Choice const& choice, Freedoms const& fifos) {
    return cost_of(sum_of(choice, fifos, CostWeights()), CostWeights());
}

/// Of a row of a table in Markdown, without the blanks around them.
std::vector<std::string> cells_of(std::string const& line) {
    std::vector<std::string> cells;
    std::istringstream rest(line);
    std::string cell;
    std::getline(rest, cell, '|');
    while (std::getline(rest, cell, '|'))
        cells.push_back(cell.size() > 1 ? cell.substr(1, cell.size() - 2) : cell);
    return cells;
}

std::vector<std::string> names_in(std::string const& list) {
    std::vector<std::string> names;
    std::istringstream rest(list);
    for (std::string name; rest >> name;)
        names.push_back(name.back() == ',' ? name.substr(0, name.size() - 1) : name);
    return names;
}

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
    CHECK(bits_of(FifoId::vertex, config) == 48);
    CHECK(bits_of(FifoId::area, config) == 33);
    CHECK(bits_of(FifoId::area_reciprocal, config) == 39);
    CHECK(bits_of(FifoId::command, config) == 2);
    CHECK(bits_of(FifoId::fragment_depth, config) == 48);
    CHECK(bits_of(FifoId::edge_token, config) == 34);
    CHECK(bits_of(FifoId::observed_depth, config) == 11);
    CHECK(bits_of(FifoId::result, config) == 4 * 16 + 32);
    config.inlier_unit.sweep_lanes = 4;
    CHECK(bits_of(FifoId::edge_map, config) == 4);
    CHECK(bits_of(FifoId::observed_depth, config) == 4 * 11);
    config.rasterizer.lanes = 8;
    CHECK(bits_of(FifoId::fragment_depth, config) == 48 + 33);  // and the step of a column
    CHECK(bits_of(FifoId::fragment_index, config) == 32 + 8);
    CHECK(bits_of(FifoId::edge_token, config) == 32 + 8);
    CHECK(bits_of(FifoId::command, config) == 2);
    config.flow = Flow::fpga_grip;
    CHECK(bits_of(FifoId::edge_map, config) == 0);  // not there
    CHECK(bits_of(FifoId::edge_token, config) == 0);
    config = {};
    config.fraction_bits.area_reciprocal = 20;
    config.window = 4;
    CHECK(bits_of(FifoId::area_reciprocal, config) == 29);
    CHECK(bits_of(FifoId::result, config) == 4 * 5 + 32);
}

TEST_CASE("Every generation builds a FIFO of 16 tokens of 64 bits, and of 17, as its rules say", "[sizing]") {
    auto const built = [](FifoGeneration generation, std::uint64_t depth, FifoKind kind = FifoKind::automatic) {
        FifoChoice const choice = FifoFreedom{kind, 64, generation}.at_depth(depth);
        return std::tuple{choice.kind, choice.capacity(), choice.read_latency()};
    };
    for (FifoGeneration const generation : generations) {
        CHECK(built(generation, 2) == std::tuple{srl, 2, 1});
        CHECK(built(generation, 16, srl) == std::tuple{srl, 16, 1});
    }
    CHECK(built(FifoGeneration::spec, 3) == std::tuple{memory, 4, 2});
    CHECK(built(FifoGeneration::spec, 16) == std::tuple{memory, 17, 2});
    CHECK(built(FifoGeneration::vivado_hls, 16) == std::tuple{srl, 16, 1});
    CHECK(built(FifoGeneration::vivado_hls, 17) == std::tuple{memory, 18, 2});
    CHECK(built(FifoGeneration::vitis_hls, 16) == std::tuple{srl, 16, 1});
    CHECK(built(FifoGeneration::vitis_hls, 17) == std::tuple{memory, 17, 2});
    CHECK(built(FifoGeneration::vitis_hls, 1, memory) == std::tuple{memory, 1, 2});
    CHECK(built(FifoGeneration::vivado_hls, 2, memory) == std::tuple{memory, 3, 2});  // asked for, at whatever depth
}

TEST_CASE("The tokens of every machine are as wide as the tests' own table says", "[sizing]") {
    faster::testing::RandomConfigOptions options;
    options.any_region = true;
    options.any_buffers = true;
    options.max_lanes = 9;
    std::size_t compared = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        options.algorithm = seed % 2 == 0 ? EdgeMapAlgorithm::inner_border : EdgeMapAlgorithm::dual_map;
        options.max_scan_lanes = seed % 4 == 0 ? 32 : 1;
        options.flow = seed % 5 == 0 ? Flow::fpga_grip : Flow::faster;
        AcceleratorConfig config = faster::testing::random_config(seed, options);
        config.window = 1 + static_cast<int>(seed * 7);
        config.fraction_bits.vertex_xy = static_cast<int>(seed % 8);
        config.fraction_bits.area_reciprocal = static_cast<int>(seed % 40);
        Machine const machine = faster::testing::raster_machine(config);
        for (std::size_t const i : fifos_of(machine)) {
            CAPTURE(machine.fifos[i].name);
            CHECK(machine.fifos[i].bits == faster::testing::token_bits(faster::testing::fifo_ids[i], config));
            ++compared;
        }
    }
    CHECK(compared > 3000);
}

TEST_CASE("docs/formats.md says how wide the tokens of three designs are", "[sizing]") {
    std::ifstream file(std::string(FASTER_SOURCE_DIR) + "/docs/formats.md");
    std::vector<std::string> const presets{"faster", "next", "next_double_buffers"};
    std::map<std::string, std::vector<std::string>> widths;  // by FIFO
    bool is_in_table = false;
    for (std::string line; std::getline(file, line);) {
        std::vector<std::string> const cells = cells_of(line);
        if (cells.size() == 6 && cells[0] == "FIFO")
            is_in_table = cells[2] == "`faster`" && cells[3] == "`next`" && cells[4] == "`next_double_buffers`";
        else if (cells.size() != 6)
            is_in_table = false;
        else if (is_in_table)
            for (std::string const& fifo : names_in(cells[0]))
                widths[fifo] = {cells[2], cells[3], cells[4]};
    }
    CHECK(widths.size() == fifo_count + 1);  // and the line below the head
    for (std::size_t i = 0; i < presets.size(); ++i) {
        Machine const machine = faster::testing::raster_machine(accelerator_of(load_preset(presets[i]).config));
        for (MachineFifo const& fifo : machine.fifos) {
            CAPTURE(presets[i], fifo.name);
            REQUIRE(widths.count(fifo.name) == 1);
            CHECK(widths.at(fifo.name)[i] == (fifo.is_present ? std::to_string(fifo.bits) : "-"));
        }
    }
}

TEST_CASE("Levels are the deepest choices of each price, for every depth, as is what an answer holds", "[sizing]") {
    for (FifoKind const kind : {FifoKind::automatic, srl, memory})
        for (unsigned const bits : {1U, 2U, 11U, 34U, 48U}) {
            FifoFreedom const fifo{kind, bits, generations[bits % 3]};
            CAPTURE(static_cast<int>(kind), bits);
            std::vector<Level> const levels = levels_of(fifo, 3000, CostWeights());
            for (std::uint64_t depth = 1; depth <= 3000; ++depth) {
                FifoChoice const choice = fifo.at_depth(depth);
                Primitives const needed = primitives(choice.kind, depth, bits);
                auto const holds = [&](Level const& level) {
                    return level.choice.kind == choice.kind && level.choice.depth >= depth &&
                           level.primitives == needed;
                };
                REQUIRE(std::count_if(levels.begin(), levels.end(), holds) == 1);
                auto const is_alike = [&](std::uint64_t other) {
                    return fifo.at_depth(other).kind == choice.kind && primitives(choice.kind, other, bits) == needed;
                };
                std::uint64_t const deepest = deepest_alike(choice, fifo, CostWeights()).depth;
                REQUIRE(is_alike(deepest));
                REQUIRE(!is_alike(deepest + 1));
            }
            auto const costs_less = [](Level const& a, Level const& b) { return a.cost < b.cost; };
            CHECK(std::is_sorted(levels.begin(), levels.end(), costs_less));
        }
}

TEST_CASE("The cheapest choice that escapes all cuts is found", "[sizing]") {
    for (unsigned seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        constexpr std::size_t free = 4;  // the others have one level
        Freedoms const fifos(fifo_count, {FifoKind::automatic, 20, generations[seed % 3]});
        Levels levels(fifo_count);
        for (std::size_t i = 0; i < fifo_count; ++i)
            levels[i] = levels_of(fifos[i], i < free ? 100 + random() % 900 : 1, CostWeights());
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
                            (least < 0 || cost(choice, fifos) < least))
                            least = cost(choice, fifos);
                    }
        auto const found = cheapest_choice(levels, cuts);
        REQUIRE(found.has_value() == (least >= 0));
        if (found)
            CHECK(cost(*found, fifos) == Approx(least));
    }
}

}  // namespace dataflow::sizing::fifo_cost_test
