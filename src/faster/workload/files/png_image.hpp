#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"

namespace faster::files {

/// A picture for people: the bytes of its file.
std::string colour_png(Image<Colour> const& picture);

/// Writes a picture for people. Throws InputError if the file cannot be written.
void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture);

/// Greyscale PNG files, as they are: no scaling, no colour conversion. Every function throws InputError: a missing
/// file, one that is not an undamaged PNG, or one with another pixel type than the name says.
Image<std::uint16_t> read_png16(std::filesystem::path const& path);
Image<std::uint8_t> read_png8(std::filesystem::path const& path);
/// Of a file that has been read; the path is for messages.
Image<std::uint16_t> decode_png16(std::filesystem::path const& path, std::string_view file);

/// Throws InputError if the file cannot be written.
void write_png(std::filesystem::path const& path, Image<std::uint16_t> const& image);
void write_png(std::filesystem::path const& path, Image<std::uint8_t> const& image);

/// 255 where a map is not 0.
Image<std::uint8_t> visible(Image<std::uint8_t> map);

/// Throws the InputError for an image of the wrong size. `reason` says where the expected size comes from.
void require_size(std::filesystem::path const& path, int found_width, int found_height, int expected_width,
                  int expected_height, std::string const& reason);

}  // namespace faster::files
