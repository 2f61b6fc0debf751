#pragma once
#include <cstdint>

#include "dataflow/base/integer_bits.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::wires {

/// Widths of tokens that several modules have ends of [bits]. Formats: docs/function.md#formats.
constexpr unsigned vertex_xy = 16;
constexpr unsigned vertex_z = 16;
constexpr unsigned depth = 11;
constexpr unsigned header = 4 * 32;    ///< sample, centre_row, centre_col, triangles
constexpr unsigned valid_raster = 32;  ///< counts redraws
constexpr unsigned buffer = 1;
constexpr unsigned pixel = 2 * 16;  ///< row and column relative to the window, which may lie outside it
/// A triangle's doubled area is no more than its bounding box: x range times y range, both below 2^16.
constexpr unsigned magnitude_of_area = 2 * vertex_xy;

inline std::uint64_t window_pixels(AcceleratorConfig const& config) {
    return static_cast<std::uint64_t>(config.window) * static_cast<std::uint64_t>(config.window);
}

/// A number of pixels of the window.
inline unsigned pixel_count(AcceleratorConfig const& config) { return bits_for(window_pixels(config)); }

/// A pixel of the window, or -1 twice, which says that a region has none.
inline unsigned corner(AcceleratorConfig const& config) {
    return 2 * (bits_for(static_cast<std::uint64_t>(config.window)) + 1);
}

/// What a full buffer's token says of its region.
inline unsigned region(AcceleratorConfig const& config) {
    return config.inlier_unit.sweep_region == SweepRegion::touched ? 2 * corner(config) : 0;
}

/// The covered pixels of a group; none where tokens are single pixels.
inline unsigned mask(AcceleratorConfig const& config) {
    return config.rasterizer.lanes > 1 ? static_cast<unsigned>(config.rasterizer.lanes) : 0;
}

/// A count of hidden pixels, and the first and last row and column of the others.
inline unsigned hidden(AcceleratorConfig const& config) {
    bool const counted = counts_hidden(config.inlier_unit);
    return counted ? pixel_count(config) + 4 * bits_for(static_cast<std::uint64_t>(config.window)) : 0;
}

/// Four counters count pixels of the window once; valid_raster counts redraws too.
inline unsigned result(AcceleratorConfig const& config) {
    return 4 * pixel_count(config) + valid_raster + hidden(config);
}

}  // namespace faster::wires
