#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/reference/scorer.hpp"

// What the thesis tells of its designs (chapter 5), on a shape small enough to look at: a rectangle of eight triangles
// around a middle vertex, seen from the front.

namespace faster::edge_map_designs_test {

using Rows = std::vector<std::string>;

constexpr int side = 24;

Rows contour(EdgeMapAlgorithm algorithm) {
    auto const vertex = [](int col, int row) {
        return VertexCode{static_cast<std::int16_t>(col * 16 + 5), static_cast<std::int16_t>(row * 16 + 3), 16384};
    };
    VertexCode const middle = vertex(11, 11);
    std::vector<VertexCode> const rim{vertex(3, 4),   vertex(3, 11),  vertex(3, 18), vertex(11, 18),
                                      vertex(19, 18), vertex(19, 11), vertex(19, 4), vertex(11, 4)};
    Stimulus stimulus;
    stimulus.width = stimulus.height = stimulus.window = side;
    stimulus.observed_depth = {side, side};
    stimulus.observed_edges = {side, side};
    for (std::size_t i = 0; i < rim.size(); ++i)
        stimulus.triangles.push_back({{middle, rim[i], rim[(i + 1) % rim.size()]}});
    stimulus.samples = {{side / 2, side / 2, 0, static_cast<std::uint32_t>(rim.size())}};
    EdgeMapConfig config;
    config.algorithm = algorithm;
    reference::Scorer scorer(stimulus, config);
    scorer.run(0);
    SampleMaps const& maps = scorer.maps();
    Rows rows;
    for (int row = 0; row < side; ++row) {
        rows.emplace_back();
        for (int col = 0; col < side; ++col)
            rows.back() += maps.edge_map.at(row, col) != 0 ? '#' : maps.object_map.at(row, col) != 0 ? 'o' : '.';
    }
    return rows;
}

/// Rows `first` to `last` all look like `row`, with a line above and below, and nothing else.
Rows framed(int first, int last, std::string const& above, std::string const& row, std::string const& below) {
    Rows rows(side, std::string(side, '.'));
    for (int i = first; i <= last; ++i)
        rows[static_cast<std::size_t>(i)] = i == first ? above : i == last ? below : row;
    return rows;
}

/// The rectangle covers rows 5 to 18 and columns 4 to 19.
bool is_deep_inside(std::size_t row, std::size_t col) { return row >= 8 && row <= 15 && col >= 7 && col <= 16; }

TEST_CASE("5.1 is too thick and finds edges inside the object", "[edge_map]") {
    Rows const rows = contour(EdgeMapAlgorithm::threshold);
    CHECK(rows[10].substr(3, 18) == "######oooooo######");  // where a seam meets the outline
    CHECK(rows[9].substr(3, 3) == "###");                   // an outline of three pixels
    int inside = 0;
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t col = 0; col < side; ++col)
            inside += rows[row][col] == '#' && is_deep_inside(row, col) ? 1 : 0;
    CHECK(inside > 10);
}

TEST_CASE("5.2 misses the edges along rows", "[edge_map]") {
    std::string const row = "...#oooooooooooooooo#...";
    CHECK(contour(EdgeMapAlgorithm::transition) == framed(5, 18, row, row, row));
}

TEST_CASE("5.3, 5.4 and 4.1.2 are complete, one pixel wide", "[edge_map]") {
    std::string const edge = "....################....";
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::bounded, EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2})
        CHECK(contour(algorithm) == framed(4, 19, edge, "...#oooooooooooooooo#...", edge));
}

TEST_CASE("7.2 is complete, one pixel wide, and on the object", "[edge_map]") {
    std::string const edge = "....################....";
    CHECK(contour(EdgeMapAlgorithm::inner_border) == framed(5, 18, edge, "....#oooooooooooooo#....", edge));
}

}  // namespace faster::edge_map_designs_test
