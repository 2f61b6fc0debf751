#pragma once
#include <cstdint>
#include <filesystem>

#include "faster/data/image.hpp"

namespace faster::files {

/// The first image of a TIFF file, as it is: 16-bit grey in strips, plain or packed by LZW, Deflate or PackBits. Throws
/// InputError: a missing or damaged file, another kind of pixels, more than 16384 of them on a side.
Image<std::uint16_t> read_tiff16(std::filesystem::path const& path);

/// A depth image: PNG or TIFF, whichever the file is. Throws InputError.
Image<std::uint16_t> read_depth_counts(std::filesystem::path const& path);

}  // namespace faster::files
