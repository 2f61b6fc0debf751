#include "faster/workload/files/png_image.hpp"

#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace png_image_test {

using faster::Image;
using namespace faster::files;
using faster::test::content_of;
using faster::test::input_error_text;
using faster::test::TempFolder;

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

/// gradient16(), interlaced, with a gamma of 0.45, as libpng wrote it.
constexpr char const* interlaced_file =
    "89504E470D0A1A0A0000000D494844520000000500000003100000000159CA76F10000000467414D410000B18F0BFC610500"
    "0000264944415408D725C2410D00201003B06E4108525080C213CB83B460D1CC518DE89AA3B95BBE0729D802417630564800"
    "00000049454E44AE426082";

std::string bytes_of(std::string const& hex) {
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes.push_back(static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

/// CRC-32 of a PNG chunk, most significant byte first.
std::string checksum_of(std::string const& chunk) {
    std::uint32_t rest = ~0U;
    for (char const byte : chunk) {
        rest ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            rest = (rest >> 1) ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    std::string bytes;
    for (unsigned at = 32; at > 0; at -= 8)
        bytes.push_back(static_cast<char>(~rest >> (at - 8)));
    return bytes;
}

template <class Pixel> Image<Pixel> noise(int height, int width) {
    std::mt19937 random(static_cast<unsigned>(1000 * height + width));
    Image<Pixel> image(height, width);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            image.at(row, column) = static_cast<Pixel>(random());
    return image;
}

template <class Pixel> cv::Mat as_opencv(Image<Pixel> const& image) {
    cv::Mat pixels(image.height(), image.width(), cv::traits::Type<Pixel>::value);
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column)
            pixels.at<Pixel>(row, column) = image.at(row, column);
    return pixels;
}

bool are_equal(cv::Mat const& one, cv::Mat const& other) {
    return one.size() == other.size() && one.type() == other.type() && cv::norm(one, other, cv::NORM_INF) == 0;
}

std::filesystem::path write_of_one_pixel(TempFolder const& folder) {
    write_png(folder / "one.png", Image<std::uint16_t>(1, 1));
    return folder / "one.png";
}

TEST_CASE("Another library reads the images that we write, and we read its", "[png_image]") {
    TempFolder const folder;
    for (int const height : {1, 2, 7, 48})
        for (int const width : {1, 3, 64, 333}) {
            CAPTURE(height, width);
            auto const grey = noise<std::uint8_t>(height, width);
            auto const depth = noise<std::uint16_t>(height, width);
            write_png(folder / "grey.png", grey);
            write_png(folder / "depth.png", depth);
            CHECK(are_equal(cv::imread(folder / "grey.png", cv::IMREAD_UNCHANGED), as_opencv(grey)));
            CHECK(are_equal(cv::imread(folder / "depth.png", cv::IMREAD_UNCHANGED), as_opencv(depth)));
            cv::imwrite(folder / "grey.png", as_opencv(grey));
            cv::imwrite(folder / "depth.png", as_opencv(depth));
            CHECK(read_png8(folder / "grey.png") == grey);
            CHECK(read_png16(folder / "depth.png") == depth);
        }
}

TEST_CASE("Another library reads the pictures that we write", "[png_image]") {
    TempFolder const folder;
    Image<faster::Colour> picture(5, 9);
    cv::Mat expected(5, 9, CV_8UC3);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 9; ++column) {
            auto const red = static_cast<std::uint8_t>(7 * row), green = static_cast<std::uint8_t>(20 * column);
            picture.at(row, column) = {red, green, 200};
            expected.at<cv::Vec3b>(row, column) = {200, green, red};
        }
    write_colour_png(folder / "a.png", picture);
    CHECK(are_equal(cv::imread(folder / "a.png", cv::IMREAD_UNCHANGED), expected));
}

TEST_CASE("An interlaced image with a gamma is read as it is", "[png_image]") {
    TempFolder const folder;
    CHECK(read_png16(folder.write("a.png", bytes_of(interlaced_file))) == gradient16());
}

TEST_CASE("Pixels that cannot be decoded are an input error", "[png_image]") {
    TempFolder const folder;
    write_png(folder / "a.png", gradient16());
    std::string file = content_of(folder / "a.png");
    std::size_t const data = file.find("IDAT");
    std::size_t const end = file.find("IEND") - 8;
    for (std::size_t at = data + 4; at < data + 6; ++at) {  // the header of what is compressed
        CAPTURE(at);
        std::string damaged = file;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x11);
        damaged.replace(end, 4, checksum_of(damaged.substr(data, end - data)));
        CHECK_THAT(input_error_text([&] { read_png16(folder.write("bad.png", damaged)); }),
                   Catch::EndsWith("bad.png: cannot be decoded, expected a 16-bit greyscale PNG"));
    }
}

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

TEST_CASE("A PNG without pixels, or with too many a side, is an input error that says how many are read",
          "[png_image]") {
    TempFolder const folder;
    std::string const whole = content_of(write_of_one_pixel(folder));
    for (auto const& [width, bytes] :
         {std::pair("20000", std::string("\0\0\x4e\x20", 4)), {"0", std::string(4, '\0')}}) {
        std::string file = whole;
        file.replace(16, 4, bytes);
        file.replace(29, 4, checksum_of(file.substr(12, 17)));
        CHECK_THAT(input_error_text([&] { read_png16(folder.write("b.png", file)); }),
                   Catch::EndsWith(std::string("has ") + width +
                                   " x 1 pixels (1 to 16384 a side are read), expected a 16-bit greyscale PNG"));
    }
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
    CHECK(input_error_text([] { write_png("/nowhere/a.png", gradient16()); }) ==
          "/nowhere/a.png: cannot be written (No such file or directory)");
}

}  // namespace png_image_test
