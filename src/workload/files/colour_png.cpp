#include "workload/files/colour_png.hpp"

#include "kernel/base/files/text_file.hpp"
#include "workload/files/png_codec.hpp"

namespace faster::io {

std::string colour_png(Image<Colour> const& picture) {
    PngPixels pixels{picture.width(), picture.height(), 3, 8, {}};
    pixels.bytes.reserve(pixels.row_bytes() * static_cast<std::size_t>(pixels.height));
    for (int row = 0; row < picture.height(); ++row)
        for (int col = 0; col < picture.width(); ++col) {
            Colour const& colour = picture.at(row, col);
            pixels.bytes.insert(pixels.bytes.end(), colour.begin(), colour.end());
        }
    // A picture for people is drawn once and kept: a little more time for a third of the size.
    return encode_png(pixels, PngEffort::usual);
}

void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture) {
    write_file(path, colour_png(picture));
}

}  // namespace faster::io
