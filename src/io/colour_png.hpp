#pragma once
#include <array>
#include <cstdint>
#include <filesystem>

#include "common/image.hpp"

namespace faster::io {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

/// A picture for people. Throws InputError if the file cannot be written.
void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture);

}  // namespace faster::io
