#include "io/png_image.hpp"

#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

using faster::Image;
using namespace faster::io;
using faster::test::content_of;
using faster::test::input_error_text;
using faster::test::TempFolder;

namespace {

Image<std::uint16_t> gradient16() {
    Image<std::uint16_t> image(3, 5);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 5; ++column) {
            image.at(row, column) = static_cast<std::uint16_t>(row * 20000 + column);
        }
    }
    return image;
}

std::filesystem::path write_with_opencv(TempFolder const& folder, int type) {
    std::filesystem::path path = folder / "image.png";
    cv::imwrite(path.string(), cv::Mat(4, 4, type, cv::Scalar::all(7)));
    return path;
}

}  // namespace

TEST_CASE("A 16-bit image comes back from its PNG unchanged", "[png_image]") {
    TempFolder const folder;
    write_png(folder / "a.png", gradient16());
    CHECK(read_png16(folder / "a.png") == gradient16());
}

TEST_CASE("An 8-bit image comes back from its PNG unchanged", "[png_image]") {
    TempFolder const folder;
    Image<std::uint8_t> image(2, 3, 255);
    image.at(1, 2) = 0;
    image.at(0, 1) = 127;
    write_png(folder / "a.png", image);
    CHECK(read_png8(folder / "a.png") == image);
}

TEST_CASE("A missing image is an input error", "[png_image]") {
    CHECK(input_error_text([] { read_png16("/nowhere/a.png"); }) ==
          "/nowhere/a.png: no such file, expected a readable file");
}

TEST_CASE("An image of the wrong bit depth is an input error", "[png_image]") {
    TempFolder const folder;
    CHECK_THAT(input_error_text([&] { read_png16(write_with_opencv(folder, CV_8UC1)); }),
               Catch::EndsWith("image.png: is an 8-bit greyscale PNG, expected a 16-bit greyscale PNG"));
    CHECK_THAT(input_error_text([&] { read_png8(write_with_opencv(folder, CV_16UC1)); }),
               Catch::EndsWith("image.png: is a 16-bit greyscale PNG, expected an 8-bit greyscale PNG"));
}

TEST_CASE("An image with colours is an input error, even if all of them are grey", "[png_image]") {
    TempFolder const folder;
    CHECK_THAT(input_error_text([&] { read_png8(write_with_opencv(folder, CV_8UC3)); }),
               Catch::Contains("is an 8-bit RGB PNG"));
    CHECK_THAT(input_error_text([&] { read_png16(write_with_opencv(folder, CV_16UC4)); }),
               Catch::Contains("is a 16-bit RGB with alpha PNG"));
}

TEST_CASE("A file that is not a PNG is an input error", "[png_image]") {
    TempFolder const folder;
    CHECK_THAT(input_error_text([&] { read_png8(folder.write("a.png", "hello")); }),
               Catch::EndsWith("a.png: is not a PNG file, expected an 8-bit greyscale PNG"));
    CHECK_THAT(input_error_text([&] { read_png8(folder.write("a.png", "")); }), Catch::Contains("is not a PNG file"));
}

TEST_CASE("A PNG cut off anywhere is an input error", "[png_image]") {
    TempFolder const folder;
    write_png(folder / "a.png", gradient16());
    std::string const whole = content_of(folder / "a.png");
    for (std::size_t length = 8; length < whole.size(); ++length) {
        CAPTURE(length);
        CHECK_THAT(input_error_text([&] { read_png16(folder.write("cut.png", whole.substr(0, length))); }),
                   Catch::Contains("cut.png: is a truncated PNG file"));
    }
}

TEST_CASE("A PNG with any byte changed is an input error", "[png_image]") {
    TempFolder const folder;
    write_png(folder / "a.png", gradient16());
    std::string const whole = content_of(folder / "a.png");
    for (std::size_t position = 0; position < whole.size(); ++position) {
        CAPTURE(position);
        std::string damaged = whole;
        damaged[position] = static_cast<char>(damaged[position] ^ 0x41);
        CHECK(input_error_text([&] { read_png16(folder.write("bad.png", damaged)); }) != "(no error)");
    }
}

TEST_CASE("An image of the wrong size is an input error that says where the size comes from", "[png_image]") {
    CHECK_NOTHROW(require_size("a.png", 4, 3, 4, 3, "trace.yaml"));
    CHECK(input_error_text([] { require_size("a.png", 4, 3, 640, 480, "trace.yaml"); }) ==
          "a.png: has 4 x 3 pixels, expected 640 x 480 (trace.yaml)");
}

TEST_CASE("An image that cannot be written is an input error", "[png_image]") {
    CHECK(input_error_text([] { write_png("/nowhere/a.png", gradient16()); }) == "/nowhere/a.png: cannot be written");
}
