#include "modules/rasterizer/near_edge_scan.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

namespace faster::datapath::near_edge_scan_test {

using Rows = std::vector<std::string>;

/// The box of a triangle: `o` covered, `#` covered and near an edge, `+` near an edge and not covered.
Rows box_of(TriangleSetup const& setup, std::array<std::int64_t, 3> const& thresholds) {
    int const columns = setup.right_wall - setup.left_wall + 1;
    Rows rows;
    NearEdgeScan scan(setup, thresholds);
    while (!scan.done()) {
        NearEdgeLine const line = scan.next_line();
        rows.emplace_back(static_cast<std::size_t>(columns), ' ');
        for (int pixel = 0; pixel < line.covered.pixels(); ++pixel) {
            auto const is_within = [pixel](int first, int end) { return first <= pixel && pixel < end; };
            bool const is_covered = is_within(line.covered_first, line.covered_end);
            bool const is_near = is_within(line.near_first, line.near_end) && !is_within(line.far_first, line.far_end);
            rows.back()[static_cast<std::size_t>(line.covered.col(pixel) - setup.left_wall)] =
                is_near ? (is_covered ? '#' : '+') : (is_covered ? 'o' : '.');
        }
    }
    return rows;
}

TriangleCode triangle(int x0, int y0, int x1, int y1, int x2, int y2) {
    auto const vertex = [](int x, int y) {
        return VertexCode{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 16384};
    };
    return {{vertex(x0, y0), vertex(x1, y1), vertex(x2, y2)}};
}

TEST_CASE("Pixels near an edge lie on both of its sides", "[near_edge]") {
    // Corners (0,0), (0,8) and (8,0) in whole pixels. w0 = 64 - 8 (x + y), w1 = 8 x, w2 = 8 y. With 8 px^2 a pixel is
    // near the legs in the first two columns and rows, and near the third side where x + y is 7, 8 or 9.
    TriangleSetup const setup = set_up(triangle(0, 0, 0, 8, 8, 0), 40, 40, 0);
    REQUIRE(setup.drawn());
    CHECK(box_of(setup, {8, 8, 8}) == Rows{"#########+",  //
                                           "########+.",  //
                                           "##ooo##+..",  //
                                           "##oo##+...",  //
                                           "##o##+....",  //
                                           "####+.....",  //
                                           "###+......",  //
                                           "##+.......",  //
                                           "#+........"});
}

TEST_CASE("Threshold 0 takes pixels exactly on an edge only", "[near_edge]") {
    TriangleSetup const setup = set_up(triangle(0, 0, 0, 4, 4, 0), 40, 40, 0);
    CHECK(box_of(setup, {0, 0, 0}) == Rows{"#####.",  //
                                           "#oo#..",  //
                                           "#o#...",  //
                                           "##....",  //
                                           "#....."});
}

TEST_CASE("Thresholds are in px^2, whatever the fraction bits", "[near_edge]") {
    CHECK(threshold_codes({0.5, 1, 12.3}, 4) == std::array<std::int64_t, 3>{128, 256, 3148});
    CHECK(threshold_codes({0.5, 1, 12.3}, 0) == std::array<std::int64_t, 3>{0, 1, 12});
    CHECK(threshold_codes({1e300, 0, 0}, 15)[0] == std::int64_t{1} << 36);
}

TEST_CASE("Each line of random triangles holds what the edge values say", "[near_edge]") {
    unsigned const seed = 13;
    CAPTURE(seed);
    std::mt19937 random(seed);
    auto const draw = [&random](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    int drawn = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        TriangleSetup const setup =
            set_up(triangle(draw(400), draw(400), draw(400), draw(400), draw(400), draw(400)), 26, 26, 4);
        if (!setup.drawn())
            continue;
        ++drawn;
        std::array<std::int64_t, 3> const thresholds{draw(9000), draw(9000), draw(3) * 900};
        Rows const rows = box_of(setup, thresholds);
        REQUIRE(rows.size() == static_cast<std::size_t>(setup.bottom - setup.start_row + 1));
        for (std::size_t r = 0; r < rows.size(); ++r)
            for (std::size_t c = 0; c < rows[r].size(); ++c) {
                if (rows[r][c] == ' ')
                    continue;  // before the start
                bool inside = true, within = true, near_one = false;
                for (std::size_t i = 0; i < 3; ++i) {
                    EdgeFunction const& edge = setup.edge[i];
                    std::int64_t const w =
                        edge.at_start + edge.per_row * static_cast<std::int64_t>(r) +
                        edge.per_column * (setup.left_wall + static_cast<std::int64_t>(c) - setup.start_col);
                    inside = inside && w >= 0;
                    within = within && w >= -thresholds[i];
                    near_one = near_one || std::abs(w) <= thresholds[i];
                }
                char const expected = within && near_one ? (inside ? '#' : '+') : (inside ? 'o' : '.');
                if (rows[r][c] != expected)
                    FAIL("trial " << trial << " row " << r << " column " << c);
            }
    }
    CHECK(drawn > 1000);
}

}  // namespace faster::datapath::near_edge_scan_test
