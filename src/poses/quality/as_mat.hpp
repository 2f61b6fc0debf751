#pragma once
#include <algorithm>
#include <opencv2/core.hpp>

#include "faster/data/image.hpp"

namespace faster::quality {

/// A copy: OpenCV wants to write to what it wraps.
inline cv::Mat as_mat(Image<std::uint8_t> const& image) {
    cv::Mat mat(image.height(), image.width(), CV_8U);
    std::copy(image.pixels().begin(), image.pixels().end(), mat.begin<std::uint8_t>());
    return mat;
}

}  // namespace faster::quality
