#include "datapath/bitmap.hpp"

namespace faster::datapath {

void Bitmap::unpack(std::size_t first, std::size_t count, std::uint8_t* bytes) const {
    auto const side = static_cast<std::size_t>(side_);
    std::size_t col = first % side;
    std::size_t row_start = (first / side + 1) * static_cast<std::size_t>(words_per_row_);
    for (std::size_t i = 0; i < count; ++i) {
        bytes[i] = static_cast<std::uint8_t>(words_[row_start + (col >> 6)] >> (col & 63) & 1U);
        if (++col == side) {
            col = 0;
            row_start += static_cast<std::size_t>(words_per_row_);
        }
    }
}

}  // namespace faster::datapath
