#pragma once
#include <filesystem>
#include <string>

#include "common/image.hpp"
#include "workload/pictures/colour.hpp"

namespace faster::io {

/// A picture for people: the bytes of its file.
std::string colour_png(Image<Colour> const& picture);

/// The same as a file. Throws InputError if the file cannot be written.
void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture);

}  // namespace faster::io
