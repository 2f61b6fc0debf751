#include "faster/workload/files/tiff_image.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>
#include <tiffio.h>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace tiff_image_test {

using faster::Image;
using namespace faster::files;
using faster::test::content_of;
using faster::test::input_error_text;
using faster::test::TempFolder;

enum Tag {
    width = 256,
    height = 257,
    bits = 258,
    compression = 259,
    photometric = 262,
    strip_offsets = 273,
    orientation = 274,
    channels = 277,
    rows_per_strip = 278,
    strip_bytes = 279,
    tile_width = 322,
    tile_height = 323,
    tile_offsets = 324,
    tile_bytes = 325,
    sample_format = 339
};

/// A TIFF file of 3 x 2 pixels in a strip, written byte by byte: 0, 1, 2 and 65533, 65534, 65535. `tags` stand for
/// those of such a file.
std::string tiff_of(std::map<int, std::uint32_t> const& tags = {}, bool is_big_endian = false) {
    std::string bytes = is_big_endian ? "MM" : "II";
    auto const put = [&](std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes += static_cast<char>(value >> (8 * (is_big_endian ? count - 1 - i : i)) & 0xFF);
    };
    put(42, 2);
    put(20, 4);
    for (std::uint32_t const pixel : {0U, 1U, 2U, 65533U, 65534U, 65535U})
        put(pixel, 2);
    std::map<int, std::uint32_t> all{{width, 3},        {height, 2},        {bits, 16},    {compression, 1},
                                     {photometric, 1},  {strip_offsets, 8}, {channels, 1}, {rows_per_strip, 2},
                                     {strip_bytes, 12}, {sample_format, 1}};
    for (auto const& [tag, value] : tags)
        all[tag] = value;
    put(static_cast<std::uint32_t>(all.size()), 2);
    for (auto const& [tag, value] : all) {
        put(static_cast<std::uint32_t>(tag), 2);
        put(4, 2);  // 32 bits
        put(1, 4);
        put(value, 4);
    }
    put(0, 4);
    return bytes;
}

std::string complaint_about(std::string const& bytes) {
    TempFolder const folder;
    std::string const text = input_error_text([&] { read_tiff16(folder.write("d.tif", bytes)); });
    CHECK(text.find('\n') == std::string::npos);
    return text;
}

TEST_CASE("A TIFF file's pixels are read as they are, in either order of bytes") {
    TempFolder const folder;
    for (bool const is_big_endian : {false, true}) {
        auto const file = folder.write("d.tif", tiff_of({}, is_big_endian));
        Image<std::uint16_t> const image = read_depth_counts(file);
        CHECK(image.width() == 3);
        CHECK(image.pixels() == std::vector<std::uint16_t>{0U, 1U, 2U, 65533U, 65534U, 65535U});
    }
    CHECK_THAT(input_error_text([&] { read_depth_counts(folder.write("x", "II")); }), Catch::Contains("neither"));
    CHECK_THAT(input_error_text([&] { read_depth_counts(folder / "none"); }), Catch::Contains("no such file"));
}

cv::Mat noisy_ramp() {
    cv::Mat image(97, 131, CV_16UC1);
    for (int row = 0; row < image.rows; ++row) {
        for (int column = 0; column < image.cols; ++column)
            image.at<std::uint16_t>(row, column) = static_cast<std::uint16_t>(700 * row + 3 * column * column);
    }
    return image;
}

TEST_CASE("TIFF files packed as others write them are read") {
    TempFolder const folder;
    cv::Mat const image = noisy_ramp();
    constexpr int none = 1, lzw = 5, deflate = 8, packbits = 32773;
    for (int const packing : {none, lzw, deflate, packbits}) {
        CAPTURE(packing);
        std::string const file = (folder / "d.tif").string();
        REQUIRE(cv::imwrite(file, image, {cv::IMWRITE_TIFF_COMPRESSION, packing}));
        Image<std::uint16_t> const read = read_depth_counts(file);
        REQUIRE(read.width() == image.cols);
        REQUIRE(read.height() == image.rows);
        bool is_same = true;
        for (int row = 0; row < image.rows; ++row) {
            for (int column = 0; column < image.cols; ++column)
                is_same = is_same && read.at(row, column) == image.at<std::uint16_t>(row, column);
        }
        CHECK(is_same);
    }
}

TEST_CASE("A TIFF file of 64-bit offsets is read") {
    TempFolder const folder;
    std::string const file = (folder / "d.tif").string();
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(file.c_str(), "w8"), TIFFClose);
    for (auto const& [tag, value] : {std::pair(TIFFTAG_IMAGEWIDTH, 2),
                                     {TIFFTAG_IMAGELENGTH, 1},
                                     {TIFFTAG_BITSPERSAMPLE, 16},
                                     {TIFFTAG_SAMPLESPERPIXEL, 1},
                                     {TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK}})
        TIFFSetField(tiff.get(), static_cast<std::uint32_t>(tag), value);
    std::array<std::uint16_t, 2> row{7, 65535};
    REQUIRE(TIFFWriteScanline(tiff.get(), row.data(), 0) == 1);
    tiff.reset();
    CHECK(read_depth_counts(file).pixels() == std::vector<std::uint16_t>{7, 65535});
}

TEST_CASE("A TIFF file that is no depth image is refused, with what it is") {
    CHECK_THAT(complaint_about(tiff_of({{bits, 8}})),
               Catch::Contains("has 1 x 8-bit numbers, expected 16-bit greyscale"));
    CHECK_THAT(complaint_about(tiff_of({{bits, 32}, {sample_format, 3}})), Catch::Contains("32-bit floating point"));
    CHECK_THAT(complaint_about(tiff_of({{sample_format, 2}})), Catch::Contains("16-bit signed numbers"));
    CHECK_THAT(complaint_about(tiff_of({{channels, 3}})), Catch::Contains("has 3 x 16-bit numbers"));
    CHECK_THAT(complaint_about(tiff_of({{photometric, 0}})), Catch::Contains("is not grey with 0 for black"));
    CHECK_THAT(complaint_about(tiff_of({{compression, 7}})), Catch::Contains("packed in another way than LZW"));
    CHECK_THAT(complaint_about(tiff_of({{tile_width, 16}, {tile_height, 16}, {tile_offsets, 8}, {tile_bytes, 512}})),
               Catch::Contains("is made of tiles"));
    CHECK_THAT(complaint_about(tiff_of({{orientation, 3}})), Catch::Contains("is turned"));
    CHECK_THAT(complaint_about(tiff_of({{width, 20000}})), Catch::Contains("has 20000 x 2 pixels (1 to 16384 a side"));
    CHECK_THAT(complaint_about(tiff_of({{width, 4000000000U}})), Catch::Contains("expected 16-bit greyscale TIFF"));
    CHECK_THAT(complaint_about(tiff_of({{height, 2000}})), Catch::Contains("cut off or damaged"));
    CHECK_THAT(complaint_about(tiff_of({{rows_per_strip, 0}})), Catch::Contains("expected 16-bit greyscale TIFF"));
    CHECK_THAT(complaint_about(tiff_of({{strip_offsets, 900}})), Catch::Contains("cut off or damaged"));
    CHECK_THAT(complaint_about("II*"), Catch::Contains("is no TIFF file"));
}

TEST_CASE("A depth image that is neither TIFF nor PNG is refused, with what it may be") {
    TempFolder const folder;
    for (std::string const bytes : {"", "II", "no image"})
        CHECK_THAT(input_error_text([&] { read_depth_counts(folder.write("d.tif", bytes)); }),
                   Catch::EndsWith("d.tif: is neither a PNG nor a TIFF file, expected one of 16-bit greyscale"));
    CHECK_THAT(input_error_text([&] { read_depth_counts(folder / "none.tif"); }),
               Catch::EndsWith("none.tif: no such file, expected a readable file"));
}

TEST_CASE("A TIFF file cut off or changed anywhere is read or refused") {
    TempFolder const folder;
    std::string const plain = tiff_of();
    for (std::size_t length = 0; length < plain.size(); ++length)
        CHECK_THAT(complaint_about(plain.substr(0, length)),
                   Catch::Contains("d.tif: ") || Catch::Contains("(no error)"));
    auto const seed = static_cast<unsigned>(GENERATE(1, 2));
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int const packing : {1, 5, 8, 32773}) {
        std::string const file = (folder / "d.tif").string();
        REQUIRE(cv::imwrite(file, noisy_ramp(), {cv::IMWRITE_TIFF_COMPRESSION, packing}));
        std::string const whole = content_of(file);
        for (int trial = 0; trial < 150; ++trial) {
            std::string changed = whole;
            std::size_t const tail = changed.size() - 200;  // where the tags are
            for (int i = 0; i < 4; ++i)
                changed[trial % 2 == 0 ? random() % changed.size() : tail + random() % 200] =
                    static_cast<char>(random() % 256);
            complaint_about(changed);
        }
    }
}

}  // namespace tiff_image_test
