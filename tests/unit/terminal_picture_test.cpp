#include "faster/workload/pictures/terminal_picture.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace terminal_picture_test {

using namespace faster;
using namespace faster::pictures;

/// Edge '#', object '.', both '&', nothing ' '.
Image<Mark> contour_of(std::vector<std::string> const& lines) {
    Image<std::uint8_t> edges(static_cast<int>(lines.size()), static_cast<int>(lines[0].size()));
    Image<std::uint8_t> object = edges;
    for (int row = 0; row < edges.height(); ++row)
        for (int col = 0; col < edges.width(); ++col) {
            char const letter = lines[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)];
            edges.at(row, col) = letter == '#' || letter == '&' ? 255 : 0;
            object.at(row, col) = letter == '.' || letter == '&' ? 255 : 0;
        }
    return contour_marks(edges, object);
}

Image<Mark> const small_contour = contour_of({" ## ",    //
                                              "#..#",    //
                                              "#..&",    //
                                              " .. "});  //

TEST_CASE("Plain text has a letter for two marks, the edge before the object before nothing", "[terminal_picture]") {
    CHECK(plain_text(small_contour) == "####\n#..#\n");
}

TEST_CASE("The last of an odd number of rows stands alone, and no line ends in blanks", "[terminal_picture]") {
    CHECK(plain_text(contour_of({"# ", "  ", ". "})) == "#\n.\n");
}

TEST_CASE("Coloured text has half-blocks in the colours of both marks, and ends every line without",
          "[terminal_picture]") {
    CHECK(coloured_text(contour_of({"#.  ", "# . "})) ==
          "\033[38;2;215;25;28;48;2;215;25;28m▀"
          "\033[0;38;2;150;215;140m▀▄"
          "\033[0m \n");
    CHECK(coloured_text(contour_of({"##"})) == "\033[0;38;2;215;25;28m▀▀\033[0m\n");
    CHECK(coloured_text(contour_of({"  "})) == "  \n");
}

TEST_CASE("A picture is cropped to what is drawn", "[terminal_picture]") {
    Image<Mark> const part = cropped(contour_of({"     ", "  #  ", "   . ", "     "}));
    CHECK(part.height() == 2);
    CHECK(part.width() == 2);
    CHECK(plain_text(part) == "#.\n");
    CHECK(cropped(contour_of({"  ", "  "})).empty());
}

TEST_CASE("A picture fits: doubled, as it is, or shrunk without losing its lines", "[terminal_picture]") {
    CHECK(plain_text(fitted_to_terminal(small_contour, 8, 8)) == "  ####\n##....##\n##....##\n  ....\n");
    CHECK(fitted_to_terminal(small_contour, 8, 7).width() == 4);
    CHECK(fitted_to_terminal(small_contour, 7, 80).width() == 4);

    Image<Mark> const shrunk = fitted_to_terminal(small_contour, 80, 2);
    CHECK(shrunk.height() == 2);
    CHECK(shrunk.width() == 2);
    CHECK(plain_text(shrunk) == "##\n");

    Image<Mark> const wide = fitted_to_terminal(contour_of({std::string(100, '#')}), 10, 10);
    CHECK(wide.height() == 1);
    CHECK(wide.width() == 10);
}

TEST_CASE("Depths go from a dense letter to a point, and nothing drawn is blank", "[terminal_picture]") {
    Image<std::uint16_t> depth(1, 4, far_depth_code);
    depth.at(0, 0) = 300, depth.at(0, 1) = 360, depth.at(0, 2) = 420;
    DepthScale scale(9);
    scale.include(depth);
    CHECK(plain_text(depth_marks(depth, scale)) == "@+.\n");
    CHECK(depth_marks(depth, scale).at(0, 1).colour == scale.colour(360));
}

}  // namespace terminal_picture_test
