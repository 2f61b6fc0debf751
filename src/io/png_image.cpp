#include "io/png_image.hpp"

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "common/input_error.hpp"
#include "io/png_header.hpp"
#include "io/text_file.hpp"

namespace faster::io {
namespace {

/// Larger than any image the machine takes (4096), small enough to allocate: a damaged size must not exhaust memory.
constexpr std::uint32_t largest_side = 1U << 14;

[[noreturn]] void fail(std::filesystem::path const& path, std::string const& found, int bits) {
    throw InputError(
        fmt::format("{}: {}, expected {}-bit greyscale PNG", path.string(), found, bits == 8 ? "an 8" : "a 16"));
}

void require_pixel_type(std::filesystem::path const& path, std::string_view file, int bits) {
    PngCheck const check = check_png(file);
    if (!check.problem.empty()) {
        fail(path, check.problem, bits);
    }
    if (!check.header.is_grey() || check.header.bit_depth != bits) {
        fail(path, "is " + check.header.pixel_type() + " PNG", bits);
    }
    if (check.header.width > largest_side || check.header.height > largest_side) {
        fail(path, fmt::format("has {} x {} pixels", check.header.width, check.header.height), bits);
    }
}

cv::Mat decode(std::filesystem::path const& path, std::string const& file, int bits) {
    std::vector<unsigned char> const bytes(file.begin(), file.end());
    try {
        int const flags = cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION;
        cv::Mat pixels = cv::imdecode(bytes, flags);
        if (!pixels.empty()) {
            return pixels;
        }
    } catch (cv::Exception const&) {
        // falls through: what the decoder has to say is about itself, not about the file
    }
    fail(path, "cannot be decoded", bits);
}

template <class Pixel> Image<Pixel> read_png(std::filesystem::path const& path) {
    int const bits = static_cast<int>(8 * sizeof(Pixel));
    std::string const file = read_file(path);
    require_pixel_type(path, file, bits);
    cv::Mat const pixels = decode(path, file, bits);
    if (pixels.type() != cv::traits::Type<Pixel>::value) {
        fail(path, "cannot be decoded", bits);
    }
    Image<Pixel> image(pixels.rows, pixels.cols);
    for (int row = 0; row < pixels.rows; ++row) {
        std::copy_n(pixels.ptr<Pixel>(row), pixels.cols, image.row(row));
    }
    return image;
}

template <class Pixel> void encode_png(std::filesystem::path const& path, Image<Pixel> const& image) {
    cv::Mat pixels(image.height(), image.width(), cv::traits::Type<Pixel>::value);
    for (int row = 0; row < pixels.rows; ++row) {
        std::copy_n(image.row(row), pixels.cols, pixels.ptr<Pixel>(row));
    }
    std::vector<unsigned char> bytes;
    try {
        cv::imencode(".png", pixels, bytes);
    } catch (cv::Exception const& error) {
        throw InputError(fmt::format("{}: cannot be encoded as PNG ({})", path.string(), error.err));
    }
    write_file(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace

Image<std::uint16_t> read_png16(std::filesystem::path const& path) { return read_png<std::uint16_t>(path); }
Image<std::uint8_t> read_png8(std::filesystem::path const& path) { return read_png<std::uint8_t>(path); }

void write_png(std::filesystem::path const& path, Image<std::uint16_t> const& image) { encode_png(path, image); }
void write_png(std::filesystem::path const& path, Image<std::uint8_t> const& image) { encode_png(path, image); }

void require_size(std::filesystem::path const& path, int found_width, int found_height, int expected_width,
                  int expected_height, std::string const& reason) {
    if (found_width != expected_width || found_height != expected_height) {
        throw InputError(fmt::format("{}: has {} x {} pixels, expected {} x {} ({})", path.string(), found_width,
                                     found_height, expected_width, expected_height, reason));
    }
}

}  // namespace faster::io
