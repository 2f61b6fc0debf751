#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace faster::io {

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

}  // namespace faster::io
