#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace faster::io {

/// What a PNG file says of its pixels (chunk IHDR).
struct PngHeader {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int bit_depth = 0;
    int colour_type = 0;  ///< 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGB with alpha

    bool is_grey() const { return colour_type == 0; }
    std::string pixel_type() const;  ///< e.g. "an 8-bit RGB"
};

/// The header of a PNG file whose chunks are all there and undamaged (lengths and checksums, up to IEND). Asked before
/// decoding, because the decoder does not say what is wrong, and the pixel type decides how much room there must be.
/// `problem` is empty if all is well, else says what is wrong with the file, for a message.
/// Source: PNG specification (ISO/IEC 15948), sections 5 and 11.2.2.
struct PngCheck {
    PngHeader header;
    std::string problem;
};
PngCheck check_png(std::string_view file);

}  // namespace faster::io
