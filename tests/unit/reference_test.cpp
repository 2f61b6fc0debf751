#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/reference/depth_buffer.hpp"
#include "faster/reference/edge_map/dual_map.hpp"
#include "faster/reference/edge_tokens.hpp"
#include "faster/reference/inlier_sweep.hpp"
#include "faster/reference/rasterize.hpp"
#include "faster/reference/scorer.hpp"
#include "faster/reference/vertex_transform.hpp"

namespace reference_test {

using namespace faster;
using reference::Pixel;

// What the rasterizer tells, one entry per call and in order: O object, E edge.
struct RecordedToken {
    char kind;
    int row;
    int col;
    friend bool operator==(RecordedToken const& a, RecordedToken const& b) {
        return a.kind == b.kind && a.row == b.row && a.col == b.col;
    }
    friend std::ostream& operator<<(std::ostream& out, RecordedToken const& token) {
        return out << token.kind << '(' << token.row << ',' << token.col << ')';
    }
};

struct Recorder {
    std::vector<std::int64_t> areas;
    std::vector<std::int64_t> z_sums;
    std::vector<RecordedToken> tokens;

    void triangle(std::int64_t area) { areas.push_back(area); }
    void fragment(Pixel, std::int64_t z_sum) { z_sums.push_back(z_sum); }
    void object(Pixel pixel) { tokens.push_back({'O', pixel.row, pixel.col}); }
    void edge(Pixel pixel) { tokens.push_back({'E', pixel.row, pixel.col}); }
};

struct SampleScore {
    SampleCounters counters;
    SampleMaps maps;
};

SampleScore score_of(reference::Scorer& scorer, std::size_t sample) { return {scorer.run(sample), scorer.maps()}; }
SampleScore score_of(reference::Scorer&& scorer, std::size_t sample) { return score_of(scorer, sample); }

VertexCode vertex(int x, int y, int z = 16384) {
    return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::uint16_t>(z)};
}

Recorder draw(TriangleCode const& triangle, int width = 20, int height = 20, int fraction_bits = 4) {
    Recorder recorder;
    reference::TransitionTokens tokens;
    reference::rasterize(triangle, width, height, fraction_bits, tokens, recorder);
    return recorder;
}

// Corners at (row, column) (1,1), (3,1), (1,3); covers the six pixels with row, column >= 1 and row + column <= 4.
// Depths 1, 1.5 and 1.25 m. In codes of 1/16 px: area = (48-16)(48-16) - 0 = 1024.
TriangleCode const corner{{vertex(16, 16, 16384), vertex(16, 48, 24576), vertex(48, 16, 20480)}};

// The corner's hypotenuse turned: (1,3), (3,1), (3,3).
TriangleCode const opposite{{vertex(48, 16), vertex(16, 48), vertex(48, 48)}};

// One sample whose window is the whole square image.
Stimulus square(int side, std::vector<TriangleCode> triangles) {
    Stimulus stimulus;
    stimulus.width = side;
    stimulus.height = side;
    stimulus.window = side;
    stimulus.samples = {{side / 2, side / 2, 0, static_cast<std::uint32_t>(triangles.size())}};
    stimulus.triangles = std::move(triangles);
    stimulus.observed_depth = {side, side};
    stimulus.observed_edges = {side, side};
    return stimulus;
}

std::vector<int> row_of(Image<std::uint8_t> const& map, int row) { return {map.row(row), map.row(row) + map.width()}; }
std::vector<int> row_of(Image<std::uint16_t> const& map, int row) { return {map.row(row), map.row(row) + map.width()}; }

SampleCounters counters_of(Stimulus const& stimulus) { return reference::Scorer(stimulus).run(0); }

Mesh one_face(Eigen::Vector3d const& a, Eigen::Vector3d const& b, Eigen::Vector3d const& c) {
    return {{a, b, c}, {{{0, 1, 2}}}};
}

Camera const round_camera{640, 480, 100.0, 100.0, 320.0, 240.0};

bool is_rejected(TriangleCode const& triangle) {
    VertexCode const off = vertex(-32768, -32768, 0);
    return triangle == TriangleCode{{off, off, off}};
}

TriangleCode transform_one(Mesh const& mesh, Pose const& pose = {}, FractionBits const& fraction = {}) {
    return reference::VertexTransform(mesh, round_camera, fraction)(pose).at(0);
}

TEST_CASE("A triangle is scanned in a zig-zag whose tokens mark what it enters and leaves", "[reference][rasterizer]") {
    // Walls are columns 1 and 4; the start (1,1) is at the left one, so line 1 goes right, line 2 left, line 3 right.
    // Line 1: O O O, leaves at column 4. Line 2: columns 4, 3 outside, enters at 2: O(2,2), then the pixel before,
    // E(2,3); O(2,1) at the wall. Line 3: enters nothing, as the previous pixel was inside; leaves at column 2.
    Recorder const recorder = draw(corner);
    CHECK(recorder.areas == std::vector<std::int64_t>{1024});
    CHECK(recorder.tokens == std::vector<RecordedToken>{{'O', 1, 1},
                                                        {'O', 1, 2},
                                                        {'O', 1, 3},
                                                        {'E', 1, 4},
                                                        {'O', 2, 2},
                                                        {'E', 2, 3},
                                                        {'O', 2, 1},
                                                        {'O', 3, 1},
                                                        {'E', 3, 2}});
}

TEST_CASE("A z sum weighs the depths of the corners by the edge functions", "[reference][rasterizer]") {
    // w2 = E_01 = 32 (x - 16), w1 = E_20 = 32 (y - 16), w0 = 1024 - w1 - w2, with x, y = 16 * column, 16 * row.
    // (1,1): 1024 * 16384. (1,2): 512 * (16384 + 20480). (1,3): 1024 * 20480. (2,2): 512 * (24576 + 20480).
    // (2,1): 512 * (16384 + 24576). (3,1): 1024 * 24576.
    CHECK(draw(corner).z_sums ==
          std::vector<std::int64_t>{1024 * 16384, 512 * 36864, 1024 * 20480, 512 * 45056, 512 * 40960, 1024 * 24576});
}

TEST_CASE("A back face, a triangle without area and a rejected one draw nothing", "[reference][rasterizer]") {
    TriangleCode const back{{corner.vertex[0], corner.vertex[2], corner.vertex[1]}};
    TriangleCode const line{{vertex(16, 16), vertex(32, 32), vertex(48, 48)}};
    VertexCode const off = vertex(-32768, -32768, 0);
    for (TriangleCode const& triangle : {back, line, TriangleCode{{off, off, off}}}) {
        CHECK(draw(triangle).areas.empty());
        CHECK(draw(triangle).tokens.empty());
    }
}

TEST_CASE("A triangle is drawn only if each bound lies in the image", "[reference][rasterizer]") {
    // Bounds are the floors of the corners: column and row 3 for coordinates 48..63, -1 for -1.
    CHECK(draw(corner, 4, 4).areas.size() == 1);
    CHECK(draw(corner, 3, 4).areas.empty());
    CHECK(draw(corner, 4, 3).areas.empty());
    TriangleCode const up_to_the_edge{{vertex(0, 0), vertex(0, 48), vertex(63, 0)}};
    CHECK(draw(up_to_the_edge, 4, 4).areas.size() == 1);
    CHECK(draw({{vertex(-1, 0), vertex(0, 48), vertex(48, 0)}}, 4, 4).areas.empty());
    CHECK(draw({{vertex(0, -1), vertex(0, 48), vertex(48, 0)}}, 4, 4).areas.empty());
    CHECK(draw({{vertex(0, 0), vertex(0, 48), vertex(64, 0)}}, 4, 4).areas.empty());
}

TEST_CASE("A start away from the left wall goes left first and skips what lies to the right",
          "[reference][rasterizer]") {
    // Covered: 1 <= row <= column <= 3. The smallest y is that of vertices 0 and 1: the first, (1,3), counts; it is not
    // in the left wall, column 1, so line 1 goes left: O O O, all inside. Line 2, rightwards: leaves at (2,1), which is
    // E; enters at O(2,2), with (2,1) before it E again; O(2,3), leaves at E(2,4), the right wall. Line 3, leftwards:
    // enters at O(3,3), E(3,4) before it, leaves at E(3,2); (3,1) is outside too and the last.
    TriangleCode const triangle{{vertex(48, 16), vertex(16, 16), vertex(48, 48)}};
    CHECK(draw(triangle).tokens == std::vector<RecordedToken>{{'O', 1, 3},
                                                              {'O', 1, 2},
                                                              {'O', 1, 1},
                                                              {'E', 2, 1},
                                                              {'O', 2, 2},
                                                              {'E', 2, 1},
                                                              {'O', 2, 3},
                                                              {'E', 2, 4},
                                                              {'O', 3, 3},
                                                              {'E', 3, 4},
                                                              {'E', 3, 2}});
}

TEST_CASE("A start between the walls sees only one side of the first line", "[reference][rasterizer]") {
    // The start, (1,2), is in the middle, between walls 1 and 4. Area = (48-32)(48-16) - (16-32)(48-16) = 1024.
    // Covered: (1,2); on line 2 what is within 0.5 px of column 2, so (2,2); (3,1) to (3,3). Line 1, leftwards: O(1,2),
    // E(1,1). Line 2, rightwards from column 1: O(2,2), E(2,1) before it, E(2,3). Line 3, leftwards from column 4:
    // O(3,3), E(3,4) before it, O(3,2), O(3,1).
    TriangleCode const triangle{{vertex(32, 16), vertex(16, 48), vertex(48, 48)}};
    CHECK(draw(triangle).tokens == std::vector<RecordedToken>{{'O', 1, 2},
                                                              {'E', 1, 1},
                                                              {'O', 2, 2},
                                                              {'E', 2, 1},
                                                              {'E', 2, 3},
                                                              {'O', 3, 3},
                                                              {'E', 3, 4},
                                                              {'O', 3, 2},
                                                              {'O', 3, 1}});
}

TEST_CASE("An edge token still pending when the triangle ends is lost", "[reference][rasterizer]") {
    // V0 = (16,16), V1 = (16,32), V2 = (31,16): area = 15 * 16 = 240, bounds columns 1..1, rows 1..2, walls 1 and 2.
    // Line 1 goes right: O(1,1), leaves at E(1,2). Line 2 goes left: (2,2) is outside, O(2,1) is entered at the bottom
    // wall. The scan ends there, before the pixel in front of it, (2,2), is sent as edge.
    TriangleCode const triangle{{vertex(16, 16), vertex(16, 32), vertex(31, 16)}};
    CHECK(draw(triangle).areas == std::vector<std::int64_t>{240});
    CHECK(draw(triangle).tokens == std::vector<RecordedToken>{{'O', 1, 1}, {'E', 1, 2}, {'O', 2, 1}});
}

TEST_CASE("A sliver between the pixels is drawn but covers nothing", "[reference][rasterizer]") {
    // x from 17/16 to 18/16 px: no column lies inside. Positive area (18-17)(48-16) = 32.
    Recorder const recorder = draw({{vertex(17, 16), vertex(17, 48), vertex(18, 16)}});
    CHECK(recorder.areas == std::vector<std::int64_t>{32});
    CHECK(recorder.z_sums.empty());
    CHECK(recorder.tokens.empty());
}

TEST_CASE("Being outside is remembered from the start pixel on", "[reference][rasterizer]") {
    // The start vertex (1.5, 1.5) lies in pixel (1,1), which is not covered: row, column >= 1.5 and row + column <= 5
    // are (2,2), (2,3), (3,2). Line 1 sees nothing. Line 2, leftwards from column 4: enters at O(2,3), E(2,4) before
    // it; goes on to O(2,2), leaves at E(2,1). Line 3, rightwards from (3,1): enters at O(3,2), E(3,1) before it,
    // leaves at E(3,3).
    CHECK(draw({{vertex(24, 24), vertex(24, 56), vertex(56, 24)}}).tokens ==
          std::vector<RecordedToken>{
              {'O', 2, 3}, {'E', 2, 4}, {'O', 2, 2}, {'E', 2, 1}, {'O', 3, 2}, {'E', 3, 1}, {'E', 3, 3}});
}

TEST_CASE("An object token marks its pixel and those above and below that are not yet object",
          "[reference][edge_map]") {
    Image<std::uint8_t> edges{4, 3};
    Image<std::uint8_t> objects{4, 3};
    reference::DualMap builder(edges, objects);
    builder.object(1, 1);
    CHECK(objects.at(1, 1) == 0);  // only its second iteration marks it
    builder.next_token();
    CHECK(objects.at(1, 1) == 1);
    CHECK(edges.at(0, 1) == 1);
    CHECK(edges.at(2, 1) == 1);
    builder.object(2, 1);  // clears its own edge bit at once; above is object already
    CHECK(edges.at(2, 1) == 0);
    builder.next_token();
    CHECK(edges.at(1, 1) == 0);
    CHECK(edges.at(3, 1) == 1);
    builder.edge(2, 1);  // an object stays one
    CHECK(edges.at(2, 1) == 0);
    builder.object(0, 1);  // nor does an object above it make (1,1) an edge
    builder.next_token();
    CHECK(edges.at(1, 1) == 0);
}

TEST_CASE("Objects in the first and last line have no neighbour beyond", "[reference][edge_map]") {
    Image<std::uint8_t> edges{2, 1};
    Image<std::uint8_t> objects{2, 1};
    reference::DualMap builder(edges, objects);
    builder.object(0, 0);
    builder.next_token();
    CHECK(edges.pixels() == std::vector<std::uint8_t>{0, 1});
    builder.object(1, 0);
    builder.next_token();
    CHECK(edges.pixels() == std::vector<std::uint8_t>{0, 0});
    CHECK(objects.pixels() == std::vector<std::uint8_t>{1, 1});
}

TEST_CASE("A triangle leaves an edge map, an object map and a depth buffer", "[reference][scorer]") {
    // Depths at the six pixels [m]: 1, 1.125, 1.25; 1.25, 1.375; 1.5. With 9 fractional bits: 512, 576, 640; 640, 704;
    // 768; the area is a power of two, so nothing is truncated. Edges: above line 1, and what the tokens of the scan
    // mark, and below (3,1); (3,2) and (2,3) come both from E tokens and from the objects above them.
    Stimulus const stimulus = square(6, {corner});
    SampleScore const score = score_of(reference::Scorer(stimulus), 0);
    Image<std::uint8_t> const& edges = score.maps.edge_map;
    CHECK(row_of(edges, 0) == std::vector<int>{0, 1, 1, 1, 0, 0});
    CHECK(row_of(edges, 1) == std::vector<int>{0, 0, 0, 0, 1, 0});
    CHECK(row_of(edges, 2) == std::vector<int>{0, 0, 0, 1, 0, 0});
    CHECK(row_of(edges, 3) == std::vector<int>{0, 0, 1, 0, 0, 0});
    CHECK(row_of(edges, 4) == std::vector<int>{0, 1, 0, 0, 0, 0});
    CHECK(row_of(edges, 5) == std::vector<int>{0, 0, 0, 0, 0, 0});
    CHECK(row_of(score.maps.object_map, 1) == std::vector<int>{0, 1, 1, 1, 0, 0});
    CHECK(row_of(score.maps.object_map, 2) == std::vector<int>{0, 1, 1, 0, 0, 0});
    CHECK(row_of(score.maps.object_map, 3) == std::vector<int>{0, 1, 0, 0, 0, 0});
    CHECK(row_of(score.maps.depth_buffer, 1) == std::vector<int>{2047, 512, 576, 640, 2047, 2047});
    CHECK(row_of(score.maps.depth_buffer, 2) == std::vector<int>{2047, 640, 704, 2047, 2047, 2047});
    CHECK(row_of(score.maps.depth_buffer, 3) == std::vector<int>{2047, 768, 2047, 2047, 2047, 2047});
    CHECK(score.counters.valid_raster == 6);
    CHECK(score.counters.valid_edge == 4);    // without those in the border row 0
    CHECK(score.counters.valid_depth == 16);  // 4 x 4 without the border, observed 0 included
    CHECK(score.counters.inlier == 0);        // nothing drawn is near an observed 0
}

TEST_CASE("The last object's second iteration runs only with flush_last", "[reference][scorer]") {
    // The tokens of this triangle are O(1,1), E(1,2), O(2,1), as worked out for the lost token above.
    Stimulus const stimulus = square(6, {{{vertex(16, 16), vertex(16, 32), vertex(31, 16)}}});
    SampleMaps const plain = score_of(reference::Scorer(stimulus), 0).maps;
    CHECK(plain.object_map.at(2, 1) == 0);
    CHECK(plain.edge_map.at(2, 1) == 0);  // its first iteration did clear what O(1,1) had marked
    CHECK(plain.edge_map.at(3, 1) == 0);
    EdgeMapConfig flushing;
    flushing.flush_last = true;
    SampleMaps const flushed = score_of(reference::Scorer(stimulus, flushing), 0).maps;
    CHECK(flushed.object_map.at(2, 1) == 1);
    CHECK(flushed.edge_map.at(3, 1) == 1);
}

TEST_CASE("Any further token lets the last object's second iteration run, even one outside", "[reference][scorer]") {
    // A triangle at (1,1), then one from (8,8) on: all its tokens lie outside the window of 6 px.
    TriangleCode const first{{vertex(16, 16), vertex(16, 32), vertex(31, 16)}};
    TriangleCode const outside{{vertex(128, 128), vertex(128, 160), vertex(160, 128)}};
    Stimulus stimulus = square(20, {first, outside});
    stimulus.window = 6;
    stimulus.samples[0].centre_row = 3;
    stimulus.samples[0].centre_col = 3;
    SampleScore const score = score_of(reference::Scorer(stimulus), 0);
    CHECK(score.maps.object_map.at(2, 1) == 1);
    CHECK(score.maps.edge_map.at(3, 1) == 1);
    CHECK(score.counters.valid_raster == 2);
}

TEST_CASE("Depths are truncated where the reciprocal is", "[reference][depth]") {
    // Area code 768 (3 px^2): reciprocal = floor(2^38 / 768) = floor(357913941.33). A flat triangle at 1 m has
    // z sums 768 * 16384 = 12582912, product 2^52 - 4194304, over 2^34: 2^18 - 1.
    reference::FragmentDepth depth{FractionBits{}};
    depth.set_area(768);
    CHECK(depth.of(768 * 16384) == (1U << 18) - 1);
    depth.set_area(1024);
    CHECK(depth.of(1024 * 16384) == 1U << 18);
}

TEST_CASE("Depths keep their meaning with products beyond 64 bits and with a shift to the left", "[reference][depth]") {
    FractionBits fraction;
    fraction.area_reciprocal = 60;  // reciprocal = 2^68 / 1024, product 2^82
    reference::FragmentDepth wide(fraction);
    wide.set_area(1024);
    CHECK(wide.of(1024 * 16384) == 1U << 18);
    wide.set_area(768);
    CHECK(wide.of(768 * 16384) == (1U << 18) - 1);

    // 2 * 4 + 14 + 4 - 30 = -4: product = 1024 * 16384 * floor(2^12 / 1024) = 2^26, times 2^4 = 1 m with 30 bits.
    fraction.area_reciprocal = 4;
    fraction.fragment_depth = 30;
    reference::FragmentDepth left(fraction);
    left.set_area(1024);
    CHECK(left.of(1024 * 16384) == 1U << 30);
}

TEST_CASE("An area that the reciprocal cannot resolve gives depth 0", "[reference][depth]") {
    FractionBits fraction;
    fraction.area_reciprocal = 0;  // reciprocal = floor(2^8 / 1024) = 0
    reference::FragmentDepth depth(fraction);
    depth.set_area(1024);
    CHECK(depth.of(1024 * 16384) == 0);
}

TEST_CASE("A fragment is kept up to 2 m and up to the depth there, at its own precision", "[reference][depth]") {
    Image<std::uint16_t> codes{1, 1};
    reference::DepthBuffer buffer(codes, FractionBits{});
    std::uint64_t const metre = 1U << 18;
    buffer.draw(0, 0, 2 * metre + 1);
    CHECK(codes.at(0, 0) == far_depth_code);
    buffer.draw(0, 0, 2 * metre);
    CHECK(codes.at(0, 0) == 1024);
    buffer.draw(0, 0, metre + 511);  // trunc to 512, a code being 512 fragment codes wide
    CHECK(codes.at(0, 0) == 512);
    buffer.draw(0, 0, metre + 1);  // the same code, but behind it at the fragment's precision
    CHECK(buffer.valid_raster() == 2);
    buffer.draw(0, 0, metre);  // a redraw counts again
    CHECK(buffer.valid_raster() == 3);
}

TEST_CASE("Fragments coarser than the buffer are compared without rounding up", "[reference][depth]") {
    FractionBits fraction;
    fraction.fragment_depth = 2;  // quarters of a metre in a buffer of 1/512
    Image<std::uint16_t> codes{1, 1, 600};
    reference::DepthBuffer buffer(codes, fraction);
    CHECK(codes.at(0, 0) == far_depth_code);
    buffer.draw(0, 0, 8);
    CHECK(codes.at(0, 0) == 1024);
    codes.at(0, 0) = 600;  // 1.17 m
    buffer.draw(0, 0, 5);  // 1.25 m
    CHECK(codes.at(0, 0) == 600);
    buffer.draw(0, 0, 4);
    CHECK(codes.at(0, 0) == 512);
}

TEST_CASE("Fraction bits beyond 128 bit arithmetic are an input error", "[reference][depth]") {
    FractionBits fraction;
    fraction.area_reciprocal = 103;  // 103 + 2 * 4 + 16 = 127
    CHECK_NOTHROW(reference::FragmentDepth(fraction));
    fraction.area_reciprocal = 104;
    CHECK_THROWS_AS(reference::FragmentDepth(fraction), InputError);
    fraction.area_reciprocal = -1;
    CHECK_THROWS_AS(reference::FragmentDepth(fraction), InputError);
}

TEST_CASE("A drawn pixel is an inlier up to 2/256 m from what was observed", "[reference][inlier]") {
    // Pixel (1,1) is drawn with code 512 and is no edge; 2/256 m are 4 codes of 1/512 m.
    Stimulus stimulus = square(6, {corner});
    for (int const observed : {508, 516}) {
        stimulus.observed_depth.at(1, 1) = static_cast<std::uint16_t>(observed);
        CHECK(counters_of(stimulus).inlier == 1);
    }
    for (int const observed : {507, 517}) {
        stimulus.observed_depth.at(1, 1) = static_cast<std::uint16_t>(observed);
        CHECK(counters_of(stimulus).inlier == 0);
    }
}

TEST_CASE("With few bits in the depth buffer the threshold of 2/256 m is still exact", "[reference][inlier]") {
    Stimulus stimulus = square(6, {corner});
    stimulus.fraction.depth_buffer = 6;  // one code is 4/256 m: only equality is near enough
    stimulus.observed_depth.at(1, 1) = 64;
    CHECK(counters_of(stimulus).inlier == 1);
    stimulus.observed_depth.at(1, 1) = 65;
    CHECK(counters_of(stimulus).inlier == 0);
}

TEST_CASE("An edge pixel on the object takes its own depth", "[reference][inlier]") {
    SampleMaps maps{{3, 3}, {3, 3}, {3, 3, 600}};
    maps.edge_map.at(1, 1) = 1;
    maps.depth_buffer.at(1, 1) = 500;
    reference::ObservedWindow observed{{3, 3}, {3, 3}};
    observed.edges.at(1, 1) = 1;
    auto const counted = [&](std::uint16_t depth) {
        observed.depth.at(1, 1) = depth;
        SampleCounters counters;
        reference::sweep(maps, observed, 9, reference::EdgeDepth::of_pixel, counters);
        return counters;
    };
    CHECK(counted(504) == SampleCounters{0, 1, 1, 1, 1});
    CHECK(counted(600) == SampleCounters{0, 1, 0, 1, 0});
    maps.depth_buffer.at(1, 1) = far_depth_code;  // covered, but too far to be drawn
    CHECK(counted(0) == SampleCounters{0, 1, 0, 1, 0});
}

TEST_CASE("An edge pixel takes the depth of the first drawn neighbour: below, above, right, left",
          "[reference][inlier]") {
    // One pixel inside the border, an edge. Its neighbours differ by more than the threshold of 4 codes.
    SampleMaps maps{{3, 3}, {3, 3}, {3, 3, far_depth_code}};
    maps.edge_map.at(1, 1) = 1;
    reference::ObservedWindow observed{{3, 3}, {3, 3}};
    auto const inliers_at = [&](std::uint16_t depth) {
        observed.depth.at(1, 1) = depth;
        SampleCounters counters;
        reference::sweep(maps, observed, 9, reference::EdgeDepth::of_neighbour, counters);
        return counters.inlier;
    };
    maps.depth_buffer.at(1, 1) = 500;  // its own depth does not count
    CHECK(inliers_at(500) == 0);
    maps.depth_buffer.at(1, 0) = 900;
    CHECK(inliers_at(900) == 1);
    maps.depth_buffer.at(1, 2) = 800;
    CHECK(inliers_at(800) == 1);
    maps.depth_buffer.at(0, 1) = 700;
    CHECK(inliers_at(700) == 1);
    maps.depth_buffer.at(2, 1) = 600;
    CHECK(inliers_at(600) == 1);
    maps.depth_buffer.at(2, 1) = 1024;  // 2 m: not drawn
    CHECK(inliers_at(700) == 1);
}

TEST_CASE("An inlier is an edge inlier if both edge bits are set", "[reference][inlier]") {
    // Edge (2,3): below (3,3) is far, above (1,3) has 640.
    Stimulus stimulus = square(6, {corner});
    stimulus.observed_depth.at(2, 3) = 640;
    CHECK(counters_of(stimulus).inlier == 1);
    CHECK(counters_of(stimulus).edge_inlier == 0);
    stimulus.observed_edges.at(2, 3) = 1;
    CHECK(counters_of(stimulus).edge_inlier == 1);
    stimulus.observed_depth.at(2, 3) = 704;
    CHECK(counters_of(stimulus).inlier == 0);
    CHECK(counters_of(stimulus).edge_inlier == 0);
    // (1,1) is drawn with 512 and no edge: an observed one alone does not count.
    stimulus.observed_depth.at(1, 1) = 512;
    stimulus.observed_edges.at(1, 1) = 1;
    CHECK(counters_of(stimulus).inlier == 1);
    CHECK(counters_of(stimulus).edge_inlier == 0);
}

TEST_CASE("An edge pixel without a drawn neighbour has depth 0", "[reference][inlier]") {
    // A flat triangle at 2 m exactly: drawn (2 m is kept) but not below 2 m, so its edges see no neighbour, and an
    // observed 0 to 4 agrees with them. Of its edges (1,4), (2,3), (3,2), (4,1) none is in the border.
    Stimulus stimulus = square(6, {{{vertex(16, 16, 32768), vertex(16, 48, 32768), vertex(48, 16, 32768)}}});
    SampleCounters const counters = counters_of(stimulus);
    CHECK(counters.valid_raster == 6);
    CHECK(counters.valid_edge == 4);
    CHECK(counters.inlier == 4);
    stimulus.observed_depth.at(2, 3) = 5;
    CHECK(counters_of(stimulus).inlier == 3);
}

TEST_CASE("Observed depths are valid up to 3 m, whatever was drawn", "[reference][inlier]") {
    Stimulus stimulus = square(4, {});
    CHECK(counters_of(stimulus).valid_depth == 4);
    stimulus.observed_depth.at(1, 1) = 3 * 512;
    CHECK(counters_of(stimulus).valid_depth == 4);
    stimulus.observed_depth.at(1, 2) = 3 * 512 + 1;
    CHECK(counters_of(stimulus).valid_depth == 3);
    stimulus.observed_depth.at(0, 0) = far_depth_code;  // border
    CHECK(counters_of(stimulus).valid_depth == 3);
}

TEST_CASE("Where the window leaves the image, 0 is observed", "[reference][inlier]") {
    Stimulus stimulus = square(6, {corner});
    for (std::uint16_t& depth : stimulus.observed_depth.pixels()) {
        depth = far_depth_code;
    }
    CHECK(counters_of(stimulus).valid_depth == 0);
    // Window rows and columns -2 .. 3 of the image: inside it are 4 x 4, of which 3 x 3 are not in the window's border.
    stimulus.samples[0].centre_row = 1;
    stimulus.samples[0].centre_col = 1;
    SampleScore const score = score_of(reference::Scorer(stimulus), 0);
    CHECK(score.counters.valid_depth == 16 - 9);
    CHECK(score.maps.depth_buffer.at(3, 3) == 512);  // the pixel (1,1) of the image
    CHECK(score.counters.valid_raster == 6);
    stimulus.samples[0].centre_row = std::numeric_limits<std::int32_t>::min();
    stimulus.samples[0].centre_col = std::numeric_limits<std::int32_t>::max();
    CHECK(counters_of(stimulus).valid_depth == 16);
    CHECK(counters_of(stimulus).valid_raster == 0);
}

TEST_CASE("Fragments and tokens outside the window are dropped", "[reference][scorer]") {
    // Odd window: offset = 2 - 3 / 2 = 1. Rows and columns 1..3 of the image, all of the corner's pixels.
    Stimulus stimulus = square(6, {corner});
    stimulus.window = 3;
    stimulus.samples[0].centre_row = 2;
    stimulus.samples[0].centre_col = 2;
    SampleScore score = score_of(reference::Scorer(stimulus), 0);
    CHECK(score.counters.valid_raster == 6);
    CHECK(score.maps.edge_map.pixels() == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 1, 0});
    // One column on: (1,1), (2,1) and (3,1) are outside.
    stimulus.samples[0].centre_col = 3;
    score = score_of(reference::Scorer(stimulus), 0);
    CHECK(score.counters.valid_raster == 3);
    CHECK(score.maps.depth_buffer.pixels() ==
          std::vector<std::uint16_t>{576, 640, 2047, 704, 2047, 2047, 2047, 2047, 2047});
}

TEST_CASE("A window of one pixel is all border", "[reference][scorer]") {
    Stimulus stimulus = square(6, {corner});
    stimulus.window = 1;
    stimulus.samples[0].centre_row = 1;
    stimulus.samples[0].centre_col = 1;
    SampleScore const score = score_of(reference::Scorer(stimulus), 0);
    CHECK(score.counters == SampleCounters{1, 0, 0, 0, 0});
    CHECK(score.maps.object_map.at(0, 0) == 1);
}

TEST_CASE("A sample does not depend on the samples run before", "[reference][scorer]") {
    Stimulus stimulus = square(6, {corner, opposite});
    stimulus.samples = {{3, 3, 0, 1}, {3, 3, 1, 1}, {3, 3, 0, 2}, {3, 3, 2, 0}};
    reference::Scorer scorer(stimulus);
    for (std::size_t const sample : {std::size_t{2}, std::size_t{1}, std::size_t{3}, std::size_t{0}}) {
        SampleScore const fresh = score_of(reference::Scorer(stimulus), sample);
        SampleScore const used = score_of(scorer, sample);
        CHECK(used.counters == fresh.counters);
        CHECK(used.maps.edge_map == fresh.maps.edge_map);
        CHECK(used.maps.object_map == fresh.maps.object_map);
        CHECK(used.maps.depth_buffer == fresh.maps.depth_buffer);
        CHECK(scorer.maps().edge_map == fresh.maps.edge_map);
    }
    CHECK_THROWS_AS(scorer.run(4), std::out_of_range);
}

TEST_CASE("A stimulus that does not hang together is an input error", "[reference][scorer]") {
    Stimulus stimulus = square(6, {corner});
    SECTION("triangles that are not there") { stimulus.samples[0].first_triangle = 1; }
    SECTION("no window") { stimulus.window = 0; }
    SECTION("an image of another size") { stimulus.observed_edges = {6, 5}; }
    SECTION("a sample without a pose") { stimulus.posed.poses.resize(2); }
    CHECK_THROWS_AS(reference::Scorer(stimulus), InputError);
}

TEST_CASE("A vertex is projected and truncated towards minus infinity", "[reference][transform]") {
    // u = 100 x / z + 320, v = 100 y / z + 240 in steps of 1/16 px, z in steps of 1/16384 m.
    // (0.01, -0.02, 1): 321, 238 -> 5136, 3808, 16384.
    // (-3.2001, 0, 1): u = -0.01 -> -0.16 -> -1, v = 240 -> 3840.
    // (0, 0, 1.5): z = 24576.
    TriangleCode const codes = transform_one(one_face({0.01, -0.02, 1.0}, {-3.2001, 0.0, 1.0}, {0.0, 0.0, 1.5}));
    CHECK(codes == TriangleCode{{vertex(5136, 3808, 16384), vertex(-1, 3840, 16384), vertex(5120, 3840, 24576)}});
}

TEST_CASE("The pose turns and moves the mesh before it is projected", "[reference][transform]") {
    Pose pose;
    pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // x -> y, y -> -x
    pose.translation = {0.5, 0.0, 2.0};
    // (0.1, 0.2, 0) -> (-0.2, 0.1, 0) + t = (0.3, 0.1, 2): u = 335, v = 245.
    TriangleCode const codes = transform_one(one_face({0.1, 0.2, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), pose);
    CHECK(codes.vertex[0] == vertex(335 * 16, 245 * 16, 32768));
    CHECK(codes.vertex[1] == vertex(345 * 16, 240 * 16, 32768));
}

TEST_CASE("Faces share transformed vertices and keep mesh and face order", "[reference][transform]") {
    Mesh const mesh{{{0, 0, 1}, {0.01, 0, 1}, {0, 0.01, 1}, {0.01, 0.01, 9}}, {{{2, 0, 1}}, {{1, 2, 3}}, {{0, 1, 2}}}};
    auto const codes = reference::VertexTransform(mesh, round_camera, FractionBits{})(Pose{});
    REQUIRE(codes.size() == 3);
    VertexCode const v0 = vertex(5120, 3840);
    VertexCode const v1 = vertex(5136, 3840);
    VertexCode const v2 = vertex(5120, 3856);
    CHECK(codes[0] == TriangleCode{{v2, v0, v1}});
    CHECK(is_rejected(codes[1]));  // for one far vertex
    CHECK(codes[2] == TriangleCode{{v0, v1, v2}});
}

TEST_CASE("Depths from 0.1 to 3.99 m are accepted, both included", "[reference][transform]") {
    auto const at = [](double z) { return transform_one(one_face({0, 0, 1}, {0, 0, z}, {0, 0, 1})); };
    double const infinity = std::numeric_limits<double>::infinity();
    CHECK(at(0.1).vertex[1].z == 1638);    // 1638.4
    CHECK(at(3.99).vertex[1].z == 65372);  // 65372.16
    CHECK(is_rejected(at(std::nextafter(0.1, 0.0))));
    CHECK(is_rejected(at(std::nextafter(3.99, 4.0))));
    CHECK(is_rejected(at(-1.0)));
    CHECK(is_rejected(at(infinity)));
    CHECK(is_rejected(at(std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("A vertex whose x or y code does not fit 16 bits rejects its triangle", "[reference][transform]") {
    // s16 with 4 fractional bits ends before 2048 px: u = 100 x + 320 = 2047.9375 for x = 17.279375.
    auto const at = [](double x, double y) { return transform_one(one_face({0, 0, 1}, {x, y, 1}, {0, 0, 1})); };
    double const nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(at(17.2795, 0.0).vertex[1].x == 32767);
    CHECK(is_rejected(at(17.2801, 0.0)));
    CHECK(at(-23.6799, 0.0).vertex[1].x == -32768);  // -2047.99 px, floor of -32767.84
    CHECK(is_rejected(at(-23.6801, 0.0)));
    CHECK(at(0.0, 18.0795).vertex[1].y == 32767);
    CHECK(is_rejected(at(0.0, 18.0801)));
    CHECK(is_rejected(at(nan, 0.0)));
    CHECK(is_rejected(at(0.0, std::numeric_limits<double>::infinity())));
}

TEST_CASE("With more bits for z a far vertex has no code and rejects its triangle", "[reference][transform]") {
    FractionBits fraction;
    fraction.vertex_z = 16;  // u16 ends before 1 m
    CHECK(transform_one(one_face({0, 0, 0.5}, {0, 0, 0.5}, {0, 0, 0.5}), {}, fraction).vertex[0].z == 32768);
    CHECK(is_rejected(transform_one(one_face({0, 0, 0.5}, {0, 0, 1.0}, {0, 0, 0.5}), {}, fraction)));
}

TEST_CASE("The sums of the transform run from left to right", "[reference][transform]") {
    // x: ((1e16 * 1 + 1 * 1) - 1e16 * 1) + 0 = 0, as 1e16 + 1 rounds to 1e16 (half to even); any other order gives 1.
    Pose pose;
    pose.rotation << 1e16, 1, -1e16, 0, 0, 0, 0, 0, 1;
    TriangleCode const codes = transform_one(one_face({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), pose);
    CHECK(codes.vertex[0].x == 320 * 16);
}

TEST_CASE("A posed stimulus gives the scores of its transformed triangles", "[reference][scorer]") {
    Stimulus posed = square(60, {});
    posed.window = 40;
    posed.posed.mesh = one_face({0.0, 0.0, 0.0}, {0.0, 0.12, 0.1}, {0.13, 0.0, 0.05});
    posed.posed.camera = {60, 60, 100.0, 100.0, 30.0, 30.0};
    posed.posed.poses.resize(2);
    posed.posed.poses[0].translation = {0.0, 0.0, 1.0};
    posed.posed.poses[1].translation = {-0.1, 0.05, 0.8};
    posed.samples = {{30, 30, 0, 0}, {36, 17, 0, 0}};

    Stimulus trace = posed;
    trace.posed = {};
    for (std::size_t i = 0; i < 2; ++i) {
        auto const codes = reference::VertexTransform(posed.posed.mesh, posed.posed.camera, {})(posed.posed.poses[i]);
        trace.triangles.push_back(codes.at(0));
        trace.samples[i].first_triangle = static_cast<std::uint32_t>(i);
        trace.samples[i].triangle_count = 1;
    }
    reference::Scorer from_mesh(posed);
    reference::Scorer from_codes(trace);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(from_mesh.run(i) == from_codes.run(i));
        CHECK(from_mesh.maps().depth_buffer == from_codes.maps().depth_buffer);
        CHECK(from_mesh.maps().edge_map == from_codes.maps().edge_map);
        CHECK(from_mesh.run(i).valid_raster > 50);
    }
}

}  // namespace reference_test
