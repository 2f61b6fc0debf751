#include "io/colour_png.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "io/text_file.hpp"

namespace faster::io {

std::string colour_png(Image<Colour> const& picture) {
    cv::Mat pixels(picture.height(), picture.width(), CV_8UC3);
    for (int row = 0; row < picture.height(); ++row)
        for (int col = 0; col < picture.width(); ++col) {
            Colour const& c = picture.at(row, col);
            pixels.at<cv::Vec3b>(row, col) = {c[2], c[1], c[0]};  // OpenCV keeps blue first
        }
    // A picture for people is drawn once and kept: a little more time for a third of the size.
    std::vector<int> const options{cv::IMWRITE_PNG_COMPRESSION, 6, cv::IMWRITE_PNG_STRATEGY,
                                   cv::IMWRITE_PNG_STRATEGY_DEFAULT};
    std::vector<unsigned char> bytes;
    cv::imencode(".png", pixels, bytes, options);
    return {bytes.begin(), bytes.end()};
}

void write_colour_png(std::filesystem::path const& path, Image<Colour> const& picture) {
    write_file(path, colour_png(picture));
}

}  // namespace faster::io
