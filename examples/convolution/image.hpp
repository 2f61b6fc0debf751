#pragma once
#include <cstddef>
#include <cstdint>

namespace convolution {

using Pixel = std::uint8_t;
using Sum = std::uint32_t;  ///< of nine weighted pixels

/// All different, so that a mixed-up window is noticed.
constexpr Sum weights[3][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};

/// The images that the design works on, one per sample: made up, and never stored.
struct Images {
    std::size_t rows;
    std::size_t cols;

    std::size_t pixels() const { return rows * cols; }
    Pixel pixel(std::size_t image, std::size_t row, std::size_t col) const {
        return static_cast<Pixel>(31 * image + 13 * row * row + 7 * col + row * col);
    }
};

/// The sum of the 3 x 3 pixels that end at (row, col), as a plain loop works it out. What lies outside the image is 0.
/// The result of the design is compared with this.
inline Sum plain_sum(Images const& images, std::size_t image, std::size_t row, std::size_t col) {
    Sum sum = 0;
    for (std::size_t up = 0; up < 3 && up <= row; ++up)
        for (std::size_t left = 0; left < 3 && left <= col; ++left)
            sum += weights[2 - up][2 - left] * images.pixel(image, row - up, col - left);
    return sum;
}

}  // namespace convolution
