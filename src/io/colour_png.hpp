#pragma once
#include <filesystem>

#include "common/colour.hpp"
#include "common/image.hpp"

namespace faster::io {

/// A picture for people. Throws InputError if the file cannot be written.
void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture);

}  // namespace faster::io
