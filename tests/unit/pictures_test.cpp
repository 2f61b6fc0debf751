#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/contact_sheet.hpp"
#include "faster/workload/pictures/depth_map.hpp"
#include "faster/workload/pictures/depth_scale.hpp"
#include "faster/workload/pictures/drawing.hpp"
#include "faster/workload/pictures/line_plot.hpp"
#include "faster/workload/pictures/overlay.hpp"

namespace pictures_test {

using namespace faster;
using namespace faster::pictures;

constexpr std::uint16_t far = far_depth_code;
constexpr int default_fraction_bits = 9;

template <class Pixel> Image<Pixel> image_of(int height, int width, std::vector<Pixel> const& pixels) {
    Image<Pixel> image(height, width);
    image.pixels() = pixels;
    return image;
}

DepthScale scale_of(Image<std::uint16_t> const& depth_buffer, int fraction_bits = default_fraction_bits) {
    DepthScale scale(fraction_bits);
    scale.include(depth_buffer);
    return scale;
}

/// As bright as the eye sees it, nearly.
int brightness(Colour c) { return 2 * c[0] + 5 * c[1] + c[2]; }

bool has_colour(Image<Colour> const& picture, Colour colour) {
    for (Colour const& pixel : picture.pixels())
        if (pixel == colour)
            return true;
    return false;
}

TEST_CASE("An overlay has the edge map over the object map over the observed edges", "[pictures]") {
    // All eight combinations: edge, object, observed.
    Image<std::uint8_t> const edges = image_of<std::uint8_t>(2, 4, {255, 255, 255, 255, 0, 0, 0, 0});
    Image<std::uint8_t> const object = image_of<std::uint8_t>(2, 4, {0, 0, 255, 255, 0, 0, 255, 255});
    Image<std::uint8_t> const observed = image_of<std::uint8_t>(2, 4, {0, 1, 0, 1, 0, 1, 0, 1});
    Image<Colour> const picture = overlay(edges, object, observed);
    Colour const red = palette::edge_map, both = palette::edge_on_observed_edge, green = palette::object_map;
    CHECK(picture ==
          image_of<Colour>(2, 4, {red, both, red, both, palette::paper, palette::observed_edges, green, green}));
}

TEST_CASE("The colours of an overlay are red, green and blue above all", "[pictures]") {
    Colour const red = palette::edge_map, green = palette::object_map, blue = palette::observed_edges;
    CHECK((red[0] > red[1] && red[0] > red[2]));
    CHECK((green[1] > green[0] && green[1] > green[2]));
    CHECK((blue[2] > blue[0] && blue[2] > blue[1]));
}

TEST_CASE("Observed edges are cut out around the sample's centre", "[pictures]") {
    Stimulus stimulus;
    stimulus.width = 6;
    stimulus.height = 5;
    stimulus.window = 4;
    stimulus.observed_edges = Image<std::uint8_t>(5, 6);
    stimulus.observed_edges.at(0, 0) = 1;
    stimulus.observed_edges.at(3, 5) = 1;
    SampleInput sample;

    SECTION("across the image's corner") {
        sample.centre_row = 1, sample.centre_col = 0;
        Image<std::uint8_t> expected(4, 4);
        expected.at(1, 2) = 1;
        CHECK(observed_edges_in_window(stimulus, sample) == expected);
    }
    SECTION("at its right border") {
        sample.centre_row = 2, sample.centre_col = 5;
        Image<std::uint8_t> expected(4, 4);
        expected.at(3, 2) = 1;
        CHECK(observed_edges_in_window(stimulus, sample) == expected);
    }
    SECTION("far beyond it") {
        sample.centre_row = 2147483647, sample.centre_col = -2147483647 - 1;
        CHECK(observed_edges_in_window(stimulus, sample) == Image<std::uint8_t>(4, 4));
    }
}

TEST_CASE("A depth map goes from the bright to the dark end of viridis, and is grey where nothing is drawn",
          "[pictures]") {
    Image<std::uint16_t> const depth = image_of<std::uint16_t>(1, 4, {300, 360, 420, far});
    Image<Colour> const picture = depth_map(depth, scale_of(depth));
    CHECK(picture.at(0, 0) == Colour{253, 231, 37});  // the ends as Matplotlib publishes them
    CHECK(picture.at(0, 2) == Colour{68, 1, 84});
    CHECK(brightness(picture.at(0, 1)) < brightness(picture.at(0, 0)));
    CHECK(brightness(picture.at(0, 1)) > brightness(picture.at(0, 2)));
    CHECK(picture.at(0, 3) == palette::nothing_drawn);
}

TEST_CASE("Farther shades are darker, and none is the grey of nothing", "[pictures]") {
    for (int shade = 0; shade < DepthScale::shades; ++shade) {
        CAPTURE(shade);
        CHECK(viridis(shade) != palette::nothing_drawn);
        if (shade >= 4)  // neighbours may be equal, but for the rounding of their colours
            CHECK(brightness(viridis(shade)) < brightness(viridis(shade - 4)));
    }
}

TEST_CASE("A depth scale is in metres of the configured fraction bits", "[pictures]") {
    Image<std::uint16_t> const depth = image_of<std::uint16_t>(1, 3, {512, 1024, far});
    CHECK(scale_of(depth, 9).nearest_metres() == 1.0);
    CHECK(scale_of(depth, 9).farthest_metres() == 2.0);
    CHECK(scale_of(depth, 10).nearest_metres() == 0.5);
    CHECK(scale_of(depth, 0).farthest_metres() == 1024.0);
}

TEST_CASE("A depth scale has three to nine round ticks within its ends", "[pictures]") {
    for (int fraction_bits : {0, 9, 11})
        for (int const length : {1, 8, 9, 20, 50, 51, 99, 100, 101, 1000, 2046}) {
            CAPTURE(fraction_bits, length);
            std::uint16_t const nearest = 37;
            auto const farthest = static_cast<std::uint16_t>(std::min(2046, nearest + length));
            DepthScale const scale = scale_of(image_of<std::uint16_t>(1, 2, {nearest, farthest}), fraction_bits);
            std::vector<double> const ticks = scale.ticks();
            CHECK(ticks.size() >= 3);
            CHECK(ticks.size() <= 9);
            for (double const tick : ticks)
                CHECK((scale.position(tick) >= -1e-9 && scale.position(tick) <= 1 + 1e-9));
        }
}

TEST_CASE("A tick's label says as much as tells it from the next", "[pictures]") {
    DepthScale const scale = scale_of(image_of<std::uint16_t>(1, 2, {333, 461}));  // 0.65 m to 0.90 m
    CHECK(scale.label(scale.ticks().front()) == "0.70 m");
    CHECK(scale.label(scale.ticks().back()) == "0.90 m");
    DepthScale const wide = scale_of(image_of<std::uint16_t>(1, 2, {0, 2046}), 9);
    CHECK(wide.label(wide.ticks().back()) == "3.5 m");
}

TEST_CASE("A depth scale of one depth has it in the middle", "[pictures]") {
    DepthScale const scale = scale_of(image_of<std::uint16_t>(1, 1, {512}));
    CHECK(scale.position(1.0) == 0.5);
    CHECK(scale.nearest_metres() < scale.farthest_metres());
}

TEST_CASE("A depth scale without depths has none", "[pictures]") {
    Image<std::uint16_t> const nothing(2, 2, far);
    CHECK_FALSE(scale_of(nothing).has_depths());
    CHECK(depth_map(nothing, scale_of(nothing)) == Image<Colour>(2, 2, palette::nothing_drawn));
}

TEST_CASE("The scale bar stands on the right and leaves the picture as it is", "[pictures]") {
    Image<std::uint16_t> const depth = image_of<std::uint16_t>(1, 2, {300, 420});
    DepthScale const scale = scale_of(depth);
    Image<Colour> const map = enlarged(depth_map(depth, scale), 300);
    Image<Colour> const picture = with_scale_bar(map, scale);
    REQUIRE(picture.height() == map.height());
    REQUIRE(picture.width() > map.width());
    CHECK(picture.at(0, 0) == map.at(0, 0));
    CHECK(picture.at(299, 599) == map.at(299, 599));
    // near on top
    CHECK(picture.at(20, map.width() + 30) == viridis(0));
    CHECK(picture.at(picture.height() - 21, map.width() + 30) == viridis(DepthScale::shades - 1));
}

TEST_CASE("A picture is enlarged by repeating its pixels and shrunk by their mean", "[pictures]") {
    Colour const black{0, 0, 0}, white{255, 255, 255};
    Image<Colour> const board = image_of<Colour>(2, 2, {black, white, white, black});
    CHECK(fitted_square(board, 5) == image_of<Colour>(4, 4,
                                                      {black, black, white, white, black, black, white, white,  //
                                                       white, white, black, black, white, white, black, black}));
    Colour const mean = fitted_square(board, 1).at(0, 0);
    CHECK((mean[0] >= 127 && mean[0] <= 128));
}

TEST_CASE("A contact sheet has room for its cells and stays within its bounds", "[pictures]") {
    for (std::size_t cells : {1U, 2U, 3U, 6U, 7U, 100U, 620U, 1000U, 2400U, 5000U, 1000000U}) {
        CAPTURE(cells);
        ContactLayout const layout = contact_layout(cells);
        CHECK(layout.cells <= cells);
        CHECK((layout.cells == cells || layout.cells > 2000));
        CHECK(layout.width() <= ContactLayout::longest_side);
        CHECK(layout.height() <= ContactLayout::longest_side);
        CHECK(layout.thumb >= 40);
        std::size_t const last = layout.cells - 1;
        CHECK(layout.cell_top(last) + layout.cell_height() <= layout.height());
        CHECK(layout.cell_left(last) + layout.cell_width() <= layout.width());
    }
    CHECK(contact_layout(6).thumb == 200);
    CHECK(contact_layout(6).columns == 3);
}

TEST_CASE("A contact sheet shows overlay and depth of every cell, and what their colours mean", "[pictures]") {
    Image<std::uint16_t> const depth(32, 32, 512);
    ContactSheet sheet(2, scale_of(depth));
    Colour const colour{1, 2, 3};  // of no legend
    CHECK(sheet.room() == 2);
    CHECK_FALSE(has_colour(sheet.picture(), colour));
    for (Colour const meaning : {palette::edge_map, palette::object_map, palette::observed_edges,
                                 palette::edge_on_observed_edge, palette::nothing_drawn, viridis(0)})
        CHECK(has_colour(sheet.picture(), meaning));
    sheet.add(0, 17, Image<Colour>(32, 32, colour), depth);
    CHECK(sheet.room() == 1);
    CHECK(has_colour(sheet.picture(), colour));
    CHECK(has_colour(sheet.picture(), scale_of(depth).colour(512)));
}

TEST_CASE("No side of a contact sheet exceeds 4000 px, legend included", "[pictures]") {
    DepthScale const scale = scale_of(Image<std::uint16_t>(1, 1, 512));
    for (std::size_t const cells : {1U, 620U, 100000U}) {
        CAPTURE(cells);
        ContactSheet const sheet(cells, scale);
        CHECK(sheet.picture().width() <= 4000);
        CHECK(sheet.picture().height() <= 4000);
    }
}

TEST_CASE("The axis of a plot ends at five round steps, at or above the largest value", "[pictures]") {
    CHECK(axis_end(0) == 1);
    CHECK(axis_end(0.72) == Approx(1));
    CHECK(axis_end(1) == Approx(1));
    CHECK(axis_end(1.01) == Approx(2.5));
    CHECK(axis_end(117) == Approx(250));
    CHECK(axis_end(620) == Approx(1000));
}

TEST_CASE("Plots stand two in a row, each line in its colour", "[pictures]") {
    LinePlot const plot{"weight", "iteration", {{"best", {0.1, 0.5}}, {"mean", {0.2, 0.3}}}};
    Image<Colour> const one = drawn_plots({plot}), three = drawn_plots({plot, plot, plot});
    CHECK(three.width() == 2 * one.width());
    CHECK(three.height() == 2 * one.height());
    CHECK(has_colour(one, palette::lines[0]));
    CHECK(has_colour(one, palette::lines[1]));
    CHECK_FALSE(has_colour(one, palette::lines[2]));
    CHECK(has_colour(drawn_plots({{"one value", "iteration", {{"best", {0.4}}}}}), palette::lines[0]));
}

}  // namespace pictures_test
