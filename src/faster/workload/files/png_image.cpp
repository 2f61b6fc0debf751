#include "faster/workload/files/png_image.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>
#include <string_view>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_codec.hpp"

namespace faster::files {

namespace {

/// Larger than any image the machine takes (4096), small enough to allocate: a damaged size must not exhaust memory.
constexpr std::uint32_t largest_side = 1U << 14;

[[noreturn]] void refuse(std::filesystem::path const& path, std::string const& found, int bits) {
    throw InputError(
        fmt::format("{}: {}, expected {}-bit greyscale PNG", path.string(), found, bits == 8 ? "an 8" : "a 16"));
}

PngHeader require_pixel_type(std::filesystem::path const& path, std::string_view file, int bits) {
    PngCheck const check = check_png(file);
    if (!check.problem.empty()) {
        refuse(path, check.problem, bits);
    }
    if (!check.header.is_grey() || check.header.bit_depth != bits) {
        refuse(path, "is " + check.header.pixel_type() + " PNG", bits);
    }
    if (std::min(check.header.width, check.header.height) == 0 ||
        std::max(check.header.width, check.header.height) > largest_side) {
        refuse(path,
               fmt::format("has {} x {} pixels (1 to {} a side are read)", check.header.width, check.header.height,
                           largest_side),
               bits);
    }
    return check.header;
}

template <class Pixel> Image<Pixel> decode(std::filesystem::path const& path, std::string_view file) {
    int const bits = static_cast<int>(8 * sizeof(Pixel));
    PngHeader const header = require_pixel_type(path, file, bits);
    PngPixels pixels{static_cast<int>(header.width), static_cast<int>(header.height), 1, bits, {}};
    if (!decode_png(file, pixels)) {
        refuse(path, "cannot be decoded", bits);
    }
    Image<Pixel> image(pixels.height, pixels.width);
    std::memcpy(image.pixels().data(), pixels.bytes.data(), pixels.bytes.size());
    return image;
}

template <class Pixel> void encode(std::filesystem::path const& path, Image<Pixel> const& image) {
    PngPixels pixels{image.width(), image.height(), 1, static_cast<int>(8 * sizeof(Pixel)), {}};
    pixels.bytes.resize(pixels.row_bytes() * static_cast<std::size_t>(pixels.height));
    std::memcpy(pixels.bytes.data(), image.pixels().data(), pixels.bytes.size());
    std::string file;
    try {
        file = encode_png(pixels, PngEffort::little);
    } catch (std::runtime_error const& error) {
        throw InputError(fmt::format("{}: cannot be encoded as PNG ({})", path.string(), error.what()));
    }
    write_file(path, file);
}

}  // namespace

std::string colour_png(Image<Colour> const& picture) {
    PngPixels pixels{picture.width(), picture.height(), 3, 8, {}};
    pixels.bytes.reserve(pixels.row_bytes() * static_cast<std::size_t>(pixels.height));
    for (Colour const& colour : picture.pixels())
        pixels.bytes.insert(pixels.bytes.end(), colour.begin(), colour.end());
    // A picture for people is drawn once and kept: a little more time for a third of the size.
    return encode_png(pixels, PngEffort::usual);
}

void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture) {
    write_file(path, colour_png(picture));
}

Image<std::uint16_t> decode_png16(std::filesystem::path const& path, std::string_view file) {
    return decode<std::uint16_t>(path, file);
}
Image<std::uint16_t> read_png16(std::filesystem::path const& path) { return decode_png16(path, read_file(path)); }
Image<std::uint8_t> read_png8(std::filesystem::path const& path) { return decode<std::uint8_t>(path, read_file(path)); }

void write_png(std::filesystem::path const& path, Image<std::uint16_t> const& image) { encode(path, image); }
void write_png(std::filesystem::path const& path, Image<std::uint8_t> const& image) { encode(path, image); }

Image<std::uint8_t> visible(Image<std::uint8_t> map) {
    for (std::uint8_t& pixel : map.pixels())
        pixel = pixel == 0 ? 0 : 255;
    return map;
}

void require_size(std::filesystem::path const& path, int found_width, int found_height, int expected_width,
                  int expected_height, std::string const& reason) {
    if (found_width != expected_width || found_height != expected_height) {
        throw InputError(fmt::format("{}: has {} x {} pixels, expected {} x {} ({})", path.string(), found_width,
                                     found_height, expected_width, expected_height, reason));
    }
}

}  // namespace faster::files
