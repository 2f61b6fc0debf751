#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "faster/reference/edge_tokens.hpp"
#include "faster/reference/rasterize.hpp"
#include "modules/rasterizer/early_exit_scan.hpp"
#include "modules/rasterizer/grouped_line.hpp"
#include "modules/rasterizer/span_scan.hpp"

namespace faster::datapath::scan_policies_test {

constexpr int image_side = 100;
constexpr int xy_fraction = 4;

struct Covered {
    int row;
    int col;
    std::int64_t z_sum;
    friend bool operator==(Covered const& a, Covered const& b) {
        return a.row == b.row && a.col == b.col && a.z_sum == b.z_sum;
    }
};

/// What the untimed reference draws, in its order.
struct ReferenceSink {
    std::vector<Covered> covered;
    void triangle(std::int64_t /*area*/) {}
    void fragment(reference::Pixel pixel, std::int64_t z_sum) { covered.push_back({pixel.row, pixel.col, z_sum}); }
    void object(reference::Pixel /*pixel*/) {}
    void edge(reference::Pixel /*pixel*/) {}
};

std::vector<Covered> reference_of(TriangleCode const& triangle) {
    ReferenceSink sink;
    reference::TransitionTokens tokens;
    reference::rasterize(triangle, image_side, image_side, xy_fraction, tokens, sink);
    return sink.covered;
}

template <class Lines> std::vector<ScanLine> lines_of(TriangleSetup const& setup) {
    std::vector<ScanLine> lines;
    for (Lines scan(setup); !scan.done();)
        lines.push_back(scan.next_line());
    return lines;
}

std::vector<Covered> covered_by(std::vector<ScanLine> const& lines) {
    std::vector<Covered> covered;
    for (ScanLine const& line : lines)
        for (int i = 0; i < line.inside; ++i)
            covered.push_back({line.row, line.col(line.before + i), line.z_sum + i * line.z_sum_per_step});
    return covered;
}

int pixels_of(std::vector<ScanLine> const& lines) {
    int pixels = 0;
    for (ScanLine const& line : lines)
        pixels += line.pixels();
    return pixels;
}

/// Corners anywhere; every third one long and a pixel or two wide, every fourth on whole pixels.
class TriangleDice {
  public:
    explicit TriangleDice(unsigned seed) : random_(seed) {}

    TriangleCode draw() {
        int const kind = below(12);
        int const grid = kind % 4 == 0 ? 1 << xy_fraction : 1;
        VertexCode const a = vertex(below(1600), below(1600), grid);
        VertexCode const b = vertex(below(1600), below(1600), grid);
        bool const is_sliver = kind % 3 == 0;
        VertexCode const c = is_sliver ? vertex(std::clamp(b.x + below(40) - 20, 0, 1599),
                                                std::clamp(b.y + below(40) - 20, 0, 1599), grid)
                                       : vertex(below(1600), below(1600), grid);
        return {{a, b, c}};
    }

  private:
    int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
    VertexCode vertex(int x, int y, int grid) {
        return {static_cast<std::int16_t>(x - x % grid), static_cast<std::int16_t>(y - y % grid),
                static_cast<std::uint16_t>(below(65536))};
    }

    std::mt19937 random_;
};

/// Calls visit(triangle, setup) for those of many random triangles that are drawn.
template <class Visit> void for_random_triangles(unsigned seed, Visit visit) {
    CAPTURE(seed);
    TriangleDice dice(seed);
    int drawn = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        TriangleCode const triangle = dice.draw();
        TriangleSetup const setup = set_up(triangle, image_side, image_side, xy_fraction);
        drawn += setup.drawn() ? 1 : 0;
        if (setup.drawn())
            visit(trial, triangle, setup);
    }
    CHECK(drawn > 1500);
}

TEST_CASE("Every scan covers the pixels of the reference, in its order", "[scan]") {
    for_random_triangles(21, [](int trial, TriangleCode const& triangle, TriangleSetup const& setup) {
        std::vector<Covered> const expected = reference_of(triangle);
        bool const same = covered_by(lines_of<ZigzagScan>(setup)) == expected &&
                          covered_by(lines_of<EarlyExitScan>(setup)) == expected &&
                          covered_by(lines_of<SpanScan>(setup)) == expected;
        if (!same)
            FAIL("trial " << trial);
    });
}

TEST_CASE("An early exit walks without a gap, inside the box, and never further than the zigzag", "[scan]") {
    std::int64_t zigzag_pixels = 0;
    std::int64_t early_pixels = 0;
    for_random_triangles(22, [&](int trial, TriangleCode const& /*triangle*/, TriangleSetup const& setup) {
        std::vector<ScanLine> const lines = lines_of<EarlyExitScan>(setup);
        int row = setup.start_row;
        int col = setup.start_col;
        for (ScanLine const& line : lines) {
            int const end = line.col(line.pixels() - 1);
            bool const walks = line.row == row && line.first_col == col && line.pixels() > 0;
            bool const is_in_box = end >= setup.left_wall && end <= setup.right_wall;
            if (!walks || !is_in_box || line.before < 0 || line.after < 0)
                FAIL("trial " << trial << " row " << line.row);
            col = end;
            ++row;
        }
        CHECK(row == setup.bottom + 1);
        CHECK(lines.back().last);
        early_pixels += pixels_of(lines);
        zigzag_pixels += pixels_of(lines_of<ZigzagScan>(setup));
    });
    CHECK(early_pixels * 3 < zigzag_pixels * 2);  // or it saves nothing
}

TEST_CASE("An early exit sees the pixels before and behind each run, as the zigzag does", "[scan]") {
    for_random_triangles(23, [](int trial, TriangleCode const& /*triangle*/, TriangleSetup const& setup) {
        std::vector<ScanLine> const zigzag = lines_of<ZigzagScan>(setup);
        std::vector<ScanLine> const early = lines_of<EarlyExitScan>(setup);
        REQUIRE(early.size() == zigzag.size());
        for (std::size_t i = 0; i < early.size(); ++i) {
            bool const same_ends = (early[i].before > 0) == (zigzag[i].before > 0) &&
                                   (early[i].inside == 0 || (early[i].after > 0) == (zigzag[i].after > 0));
            if (!same_ends || early[i].step != zigzag[i].step)
                FAIL("trial " << trial << " line " << i);
        }
    });
}

TEST_CASE("An early exit does not turn where the next row goes on", "[scan]") {
    // A triangle whose right side moves out by four columns a row: corners (1, 1), (1, 6), (21, 6) as (col, row).
    auto const at = [](int col, int row) {
        return VertexCode{static_cast<std::int16_t>(16 * col), static_cast<std::int16_t>(16 * row), 0};
    };
    TriangleSetup const setup = set_up({{at(1, 1), at(1, 6), at(21, 6)}}, image_side, image_side, xy_fraction);
    REQUIRE(setup.drawn());
    std::vector<ScanLine> const lines = lines_of<EarlyExitScan>(setup);
    REQUIRE(lines.size() == 6);
    std::vector<int> visits;
    for (ScanLine const& line : lines)
        visits.push_back(line.pixels());
    // Row 1 rightwards from column 1 past the run of row 2, which ends at 5: to column 6. Row 2 back to the wall at 1;
    // row 3, whose run ends at 9, on to 14 because of row 4; back; row 5, to 17, on to the wall at 22; back to 1.
    CHECK(visits == std::vector<int>{6, 6, 14, 14, 22, 22});
}

/// The covered pixels of a scan's groups; in a line scanned leftwards each group's are put in that order.
template <class Lines> std::vector<Covered> covered_in_groups(TriangleSetup const& setup, int lanes, int offset) {
    std::vector<Covered> covered;
    for (ScanLine const& line : lines_of<Lines>(setup)) {
        GroupedLine const grouped(line, offset, offset, lanes);
        for (int i = 0; i < (grouped.is_empty() ? 0 : grouped.inside()); ++i) {
            PixelGroup const group = grouped.pixels(i);
            DepthGroup const depths = grouped.depths(i);
            std::vector<Covered> of_group;
            for (int lane = 0; lane < lanes; ++lane)
                if ((group.mask >> lane & 1U) != 0)
                    of_group.push_back(
                        {group.row + offset, group.col + lane + offset, depths.z_sum + lane * depths.z_sum_per_column});
            if (line.step < 0)
                std::reverse(of_group.begin(), of_group.end());
            CHECK(group.mask >> (lanes - 1) <= 1);
            CHECK(group.col % lanes == 0);
            CHECK_FALSE(of_group.empty());
            covered.insert(covered.end(), of_group.begin(), of_group.end());
        }
    }
    return covered;
}

/// Groups that an early exit visits in a line: it tests whole groups until, from a group's last lane on, nothing can
/// be covered in this row nor in the next. Tested on the triangle itself.
class GroupWalk {
  public:
    GroupWalk(TriangleSetup const& setup, int lanes) : setup_(setup), lanes_(lanes), col_(setup.start_col) {}

    int visit(int row, int step) {
        int groups = 0;
        for (bool goes_on = true; goes_on;) {
            int const group = col_ / lanes_;
            int const last_lane = step > 0 ? group * lanes_ + lanes_ - 1 : group * lanes_;
            int const wall = step > 0 ? setup_.right_wall : setup_.left_wall;
            col_ = step > 0 ? std::min(last_lane, wall) : std::max(last_lane, wall);
            ++groups;
            goes_on = col_ != wall && !(falls(row, step) && (row == setup_.bottom || falls(row + 1, step)));
            col_ += goes_on ? step : 0;
        }
        return groups;
    }

  private:
    bool falls(int row, int step) const {
        return std::any_of(std::begin(setup_.edge), std::end(setup_.edge), [&](EdgeFunction const& edge) {
            std::int64_t const here =
                edge.at_start + (col_ - setup_.start_col) * edge.per_column + (row - setup_.start_row) * edge.per_row;
            return here < 0 && here + step * edge.per_column <= here;
        });
    }

    TriangleSetup const& setup_;
    int lanes_;
    int col_;
};

TEST_CASE("Groups cover the pixels of the reference, in the order of their lines", "[scan][lanes]") {
    for_random_triangles(24, [](int trial, TriangleCode const& triangle, TriangleSetup const& setup) {
        int const lanes = 1 + trial % 32;
        int const offset = trial % 77;  // a window that begins to the right of some pixels
        std::vector<Covered> const expected = reference_of(triangle);
        bool const same = covered_in_groups<ZigzagScan>(setup, lanes, offset) == expected &&
                          covered_in_groups<EarlyExitScan>(setup, lanes, offset) == expected &&
                          covered_in_groups<SpanScan>(setup, lanes, offset) == expected;
        if (!same)
            FAIL("trial " << trial);
    });
}

TEST_CASE("An early exit of groups ends where a test of the last lane says so", "[scan][lanes]") {
    for_random_triangles(25, [](int trial, TriangleCode const& /*triangle*/, TriangleSetup const& setup) {
        int const lanes = 2 + trial % 9;
        GroupWalk walk(setup, lanes);
        for (ScanLine const& line : lines_of<EarlyExitScan>(setup))
            if (GroupedLine(line, 0, 0, lanes).groups() != walk.visit(line.row, line.step))
                FAIL("trial " << trial << " row " << line.row);
    });
}

TEST_CASE("Groups of a line begin at multiples of the lanes, and its ends lie within them", "[scan][lanes]") {
    // Columns 5 to 18, of which 9 to 14 are covered, in groups of 4: 4 | 8, 12 | 16. From the right the same.
    ScanLine line;
    line.first_col = 5;
    line.before = 4;
    line.inside = 6;
    line.after = 4;
    line.z_sum = 100;
    line.z_sum_per_step = 10;
    GroupedLine const rightwards(line, 0, 0, 4);
    CHECK(rightwards.groups() == 4);
    CHECK(rightwards.before() == 1);
    CHECK(rightwards.inside() == 2);
    CHECK(rightwards.after() == 1);
    CHECK(rightwards.pixels(0).col == 8);
    CHECK(rightwards.pixels(0).mask == 0b1110);
    CHECK(rightwards.pixels(1).mask == 0b0111);
    CHECK(rightwards.depths(0).z_sum == 90);  // of column 8, which is not covered
    CHECK(rightwards.depths(1).z_sum == 130);
    line.first_col = 18;
    line.step = -1;
    GroupedLine const leftwards(line, 0, 0, 4);
    CHECK(leftwards.pixels(0).col == 12);
    CHECK(leftwards.pixels(0).mask == 0b0111);
    CHECK(leftwards.depths(0).z_sum == 120);  // 100 at column 14, ten less per column to the right
    CHECK(leftwards.depths(0).z_sum_per_column == -10);
    GroupedLine const moved(line, 0, 22, 4);  // to the left of the window: columns -17 to -4, covered -13 to -8
    CHECK(moved.groups() == 5);
    CHECK(moved.before() == 1);
    CHECK(moved.pixels(0).col == -8);
    CHECK(moved.pixels(0).mask == 0b0001);
}

}  // namespace faster::datapath::scan_policies_test
