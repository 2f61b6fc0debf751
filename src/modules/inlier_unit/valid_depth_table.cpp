#include "modules/inlier_unit/valid_depth_table.hpp"

#include <algorithm>

#include "modules/inlier_unit/compared_pixels.hpp"

namespace faster::datapath {

ValidDepthTable::ValidDepthTable(Image<std::uint16_t> const& depth, int depth_fraction)
    : height_(depth.height()),
      width_(depth.width()),
      invalid_(static_cast<std::size_t>(height_ + 1) * static_cast<std::size_t>(width_ + 1)) {
    unsigned const limit = valid_up_to(depth_fraction);
    auto const stride = static_cast<std::size_t>(width_ + 1);
    for (int row = 0; row < depth.height(); ++row) {
        std::uint32_t const* const above = invalid_.data() + static_cast<std::size_t>(row) * stride;
        std::uint32_t* const below = invalid_.data() + (static_cast<std::size_t>(row) + 1) * stride;
        std::uint32_t in_row = 0;
        for (std::size_t col = 0; col + 1 < stride; ++col) {
            in_row += depth.row(row)[col] > limit ? 1U : 0U;
            below[col + 1] = above[col + 1] + in_row;
        }
    }
}

std::uint64_t ValidDepthTable::count(std::int64_t first_row, std::int64_t first_col, int side) const {
    if (side < 3)
        return 0;
    std::int64_t const top = first_row + 1, left = first_col + 1;
    std::int64_t const bottom = first_row + side - 1, right = first_col + side - 1;
    std::uint64_t const invalid = invalid_before(bottom, right) - invalid_before(top, right) -
                                  invalid_before(bottom, left) + invalid_before(top, left);
    return static_cast<std::uint64_t>(side - 2) * static_cast<std::uint64_t>(side - 2) - invalid;
}

std::uint64_t ValidDepthTable::invalid_before(std::int64_t row, std::int64_t col) const {
    std::int64_t const r = std::clamp<std::int64_t>(row, 0, height_);
    std::int64_t const c = std::clamp<std::int64_t>(col, 0, width_);
    return invalid_[static_cast<std::size_t>(r * (width_ + 1) + c)];
}

}  // namespace faster::datapath
