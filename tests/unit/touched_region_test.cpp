#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "faster/config/lane_rows.hpp"
#include "faster/data/fixed_point.hpp"
#include "modules/inlier_unit/valid_depth_table.hpp"
#include "modules/rasterizer/touched_box.hpp"

namespace faster::touched_region_test {

using Random = std::mt19937;

int between(Random& random, int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

bool is_in(PixelBox const& box, int row, int col) {
    return row >= box.first_row && row < box.end_row && col >= box.first_col && col < box.end_col;
}

void check_same(PixelBox const& a, PixelBox const& b) {
    CHECK(a.first_row == b.first_row);
    CHECK(a.first_col == b.first_col);
    CHECK(a.end_row == b.end_row);
    CHECK(a.end_col == b.end_col);
}

TEST_CASE("A touched box holds its pixels and their margin, within the window", "[sweep_region]") {
    datapath::TouchedBox touched(10, 1);
    CHECK(touched.box().empty());
    touched.add(4, 7);
    check_same(touched.box(), {3, 6, 6, 9});
    touched.add(-1, 0);  // beside the window: its margin lies in it
    check_same(touched.box(), {0, 0, 6, 9});
    touched.add(-2, 3);
    touched.add(5, 11);
    touched.add(400, -300);
    check_same(touched.box(), {0, 0, 6, 9});
    touched.clear();
    CHECK(touched.box().empty());
    touched.add(10, 10);
    check_same(touched.box(), {9, 9, 10, 10});
}

TEST_CASE("Without a margin only pixels of the window count", "[sweep_region]") {
    datapath::TouchedBox touched(10, 0);
    touched.add(-1, 0);
    touched.add(10, 3);
    CHECK(touched.box().empty());
    touched.add(9, 0);
    check_same(touched.box(), {9, 0, 10, 1});
}

TEST_CASE("A box travels as two corners", "[sweep_region]") {
    check_same(box_of(corners_of({2, 3, 7, 4})), {2, 3, 7, 4});
    CHECK(box_of(corners_of({})).empty());
    CHECK(box_of(corners_of({3, 3, 3, 9})).empty());
}

TEST_CASE("The tokens of a box are those that have a pixel of it, row by row", "[sweep_region][lanes]") {
    Random random(20);
    for (int trial = 0; trial < 500; ++trial) {
        int const side = between(random, 1, 30);
        int const lanes = between(random, 1, side);
        PixelBox box{between(random, 0, side - 1), between(random, 0, side - 1), 0, 0};
        box.end_row = between(random, box.first_row, side);
        box.end_col = between(random, box.first_col, side);
        CAPTURE(trial, side, lanes, box.first_row, box.first_col, box.end_row, box.end_col);
        LaneRows const rows(side, lanes, box);
        std::vector<int> visits(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
        for (std::size_t done = 0; done < rows.tokens();) {
            auto const most = static_cast<std::size_t>(between(random, 1, 7));
            LaneRows::Run const run = rows.run(done, std::min(most, rows.tokens() - done));
            REQUIRE(run.tokens > 0);
            REQUIRE(run.tokens <= most);
            for (std::size_t i = 0; i < run.pixels; ++i)
                ++visits.at(run.first_pixel + i);
            done += run.tokens;
        }
        for (int row = 0; row < side; ++row)
            for (int col = 0; col < side; ++col) {
                bool const expected = !box.empty() && is_in({box.first_row, box.first_col / lanes * lanes, box.end_row,
                                                             (box.end_col + lanes - 1) / lanes * lanes},
                                                            row, col);
                CHECK(visits[static_cast<std::size_t>(row * side + col)] == (expected ? 1 : 0));
            }
    }
}

TEST_CASE("Four reads of the table count the valid depths of any window", "[sweep_region]") {
    Random random(21);
    for (int trial = 0; trial < 300; ++trial) {
        int const fraction = between(random, 0, 9);
        Image<std::uint16_t> depth(between(random, 1, 12), between(random, 1, 12));
        for (std::uint16_t& code : depth.pixels())
            code = static_cast<std::uint16_t>(random() % 3 == 0 ? (3U << fraction) + random() % 2 : random() % 2048);
        datapath::ValidDepthTable const table(depth, fraction);
        int const side = between(random, 1, 14);
        int const top = between(random, -20, 20);
        int const left = between(random, -20, 20);
        std::uint64_t expected = 0;
        for (int row = top + 1; row < top + side - 1; ++row)
            for (int col = left + 1; col < left + side - 1; ++col)
                expected += !depth.contains(row, col) || depth.at(row, col) <= 3 << fraction ? 1U : 0U;
        CAPTURE(trial, top, left, side);
        CHECK(table.count(top, left, side) == expected);
    }
}

}  // namespace faster::touched_region_test
