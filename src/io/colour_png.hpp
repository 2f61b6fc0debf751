#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "common/image.hpp"

namespace faster::io {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

/// A picture for people: the bytes of its file.
std::string colour_png(Image<Colour> const& picture);

/// The same as a file. Throws InputError if the file cannot be written.
void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture);

}  // namespace faster::io
