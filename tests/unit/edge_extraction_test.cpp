#include "modules/edge_extractor/edge_extraction.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "faster/data/fixed_point.hpp"
#include "faster/reference/edge_extraction.hpp"

namespace faster::edge_extraction_test {

constexpr int fraction = 9;
constexpr std::uint16_t metre = 1U << fraction;

using Bits = std::vector<std::uint8_t>;

Bits edges_of(std::vector<std::uint16_t> const& depths, int window, EdgeExtractionConfig const& config) {
    datapath::EdgeExtraction extraction(config, window, fraction);
    Bits edges(depths.size(), 2);
    extraction.extract(depths, edges);
    return edges;
}

EdgeExtractionConfig of_three(double threshold) {
    EdgeExtractionConfig config;
    config.neighbourhood = 3;
    config.threshold = threshold;
    config.focal_length_px = 500;
    return config;
}

std::vector<std::uint16_t> random_depths(std::mt19937& random, int window) {
    std::vector<std::uint16_t> depths(static_cast<std::size_t>(window) * static_cast<std::size_t>(window));
    for (std::uint16_t& depth : depths)
        depth = random() % 3 == 0 ? far_depth_code : static_cast<std::uint16_t>(random() % 1100);
    return depths;
}

TEST_CASE("A wall has no edges, nor has an empty window", "[edge_extraction]") {
    CHECK(edges_of(std::vector<std::uint16_t>(64, metre), 8, of_three(0.01)) == Bits(64, 0));
    CHECK(edges_of(std::vector<std::uint16_t>(64, far_depth_code), 8, of_three(0)) == Bits(64, 0));
}

TEST_CASE("A pixel before the far has the curvature worked out by hand", "[edge_extraction]") {
    // Window 3, one drawn pixel in its middle at 1 m = 512: its slopes are 0. The sum over its eight neighbours: z: 8
    // (2047 - 512) = 12280; x: the neighbours' slopes, -66, 0, 65 (floor of 65.536 and its negative), add up to -3,
    // times 2047 = -6141, likewise y. With four fractional bits kept: z 12280 x 16 = 196480, x and y floor(-6141 /
    // 2048) = -3. The root of 196480^2 + 18 is 196480 and some. The point: 512 x 16 = 8192. c = 196480 x 65536 / (8 x
    // 8192) = 196480 exactly, which is 2.998 of 65536ths.
    std::vector<std::uint16_t> depths(9, far_depth_code);
    depths[4] = metre;
    Bits expected(9, 0);
    CHECK(edges_of(depths, 3, of_three(196480.0 / 65536)) == expected);
    expected[4] = 1;
    CHECK(edges_of(depths, 3, of_three(196479.0 / 65536)) == expected);
}

TEST_CASE("Components are rounded towards minus infinity before they are squared", "[edge_extraction]") {
    // A wall at 512: in the middle of a window of 3 the slopes' -66, 0, 65 make x and y sums of -3 x 512 = -1536, which
    // becomes -1, and a z sum of 0. The root of 2 is 1, and c = 65536 / (8 x 8192) = 1.
    std::vector<std::uint16_t> const wall(9, metre);
    CHECK(edges_of(wall, 3, of_three(0))[4] == 1);
    CHECK(edges_of(wall, 3, of_three(1.0 / 65536))[4] == 0);
}

TEST_CASE("Of a step only the near side's and the far side's pixels beside it are edges", "[edge_extraction]") {
    std::vector<std::uint16_t> depths;
    for (int i = 0; i < 100; ++i)
        depths.push_back(i % 10 < 5 ? metre : metre + metre / 4);
    Bits const edges = edges_of(depths, 10, of_three(0.05));
    for (std::size_t i = 0; i < edges.size(); ++i) {
        CAPTURE(i);
        CHECK(edges[i] == (i % 10 == 4 || i % 10 == 5 ? 1 : 0));
    }
}

TEST_CASE("A point in the camera's centre is no edge", "[edge_extraction]") {
    std::vector<std::uint16_t> depths(9, metre);
    depths[4] = 0;
    CHECK(edges_of(depths, 3, of_three(0))[4] == 0);
}

TEST_CASE("Column sums give what the reference adds up term by term", "[edge_extraction]") {
    std::uint32_t const seed = GENERATE(range(1U, 31U));
    std::mt19937 random(seed);
    int const window = 1 + static_cast<int>(random() % 24);
    EdgeExtractionConfig config;
    config.neighbourhood = 3 + 2 * static_cast<int>(random() % 7);
    config.threshold = static_cast<double>(random() % 3000) / 1000;
    config.focal_length_px = random() % 4 == 0 ? 1.5 : static_cast<double>(20 + random() % 700);
    CAPTURE(seed, window, config.neighbourhood, config.threshold, config.focal_length_px);
    SampleMaps maps;
    maps.depth_buffer = Image<std::uint16_t>(window, window);
    maps.depth_buffer.pixels() = random_depths(random, window);
    maps.edge_map = maps.object_map = Image<std::uint8_t>(window, window);
    reference::extract_edges(config, fraction, maps);
    CHECK(edges_of(maps.depth_buffer.pixels(), window, config) == maps.edge_map.pixels());
}

}  // namespace faster::edge_extraction_test
