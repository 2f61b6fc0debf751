#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace faster::files {

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

/// Pixels as a PNG file has them: row by row, channel by channel, 16-bit ones in the host's order of bytes.
struct PngPixels {
    int width = 0;
    int height = 0;
    int channels = 1;  ///< 1: grey, 3: red, green, blue
    int bits = 8;      ///< of a channel: 8 or 16
    std::vector<unsigned char> bytes;

    std::size_t row_bytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) *
               static_cast<std::size_t>(bits / 8);
    }
};

/// How much time to spend on a smaller file.
enum class PngEffort { little, usual };

/// The bytes of a file. Throws std::runtime_error if libpng cannot make one.
std::string encode_png(PngPixels const& pixels, PngEffort effort);

/// Fills in the bytes of `pixels` from a file that has these pixels, as check_png() says. False if the file cannot be
/// decoded.
bool decode_png(std::string_view file, PngPixels& pixels);

}  // namespace faster::files
