#include "datapath/bitmap.hpp"

#include <algorithm>
#include <cstring>

namespace faster::datapath {

namespace {
/// Eight bits, the lowest first, as eight bytes of 0 or 1.
std::uint64_t spread(std::uint64_t bits) {
    std::uint64_t const copies = (bits & 0xFF) * 0x0101010101010101U;
    std::uint64_t const own = copies & 0x8040201008040201U;  // byte k keeps bit k
    return ((own + 0x7F7F7F7F7F7F7F7FU) | own) >> 7 & 0x0101010101010101U;
}
}  // namespace

void Bitmap::unpack(std::size_t first, std::size_t count, std::uint8_t* bytes) const {
    auto const side = static_cast<std::size_t>(side_);
    std::size_t col = first % side;
    std::size_t row = first / side + 1;
    for (std::size_t done = 0; done < count; ++row, col = 0) {
        std::uint64_t const* const words = words_.data() + row * static_cast<std::size_t>(words_per_row_);
        std::size_t const end = std::min(side, col + count - done);
        for (; col + 8 <= end && col % 8 == 0; col += 8, done += 8) {
            std::uint64_t const eight = spread(words[col >> 6] >> (col & 63));
            std::memcpy(bytes + done, &eight, sizeof eight);
        }
        for (; col < end; ++col, ++done)
            bytes[done] = static_cast<std::uint8_t>(words[col >> 6] >> (col & 63) & 1U);
    }
}

}  // namespace faster::datapath
