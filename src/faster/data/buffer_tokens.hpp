#pragma once
#include <cstddef>
#include <cstdint>

#include "faster/data/pixel_box.hpp"

namespace faster {

/// Token of `map_free` and `depth_free`: which of a unit's two buffers.
struct BufferNumber {
    BufferNumber() = default;
    explicit BufferNumber(std::size_t its_number) : number(static_cast<std::uint8_t>(its_number)) {}
    std::uint8_t number = 0;
};

/// Token of `map_full`: the maps that a sample's tokens went into, and which of their pixels are to be read out.
struct FullMaps {
    BufferNumber buffer;
    Corners region;  ///< sweep_region window: those of the window, which no FIFO need carry
};

/// Token of `depth_full`: the depth buffer that a sample was drawn into, and which of its pixels are to be swept.
struct FullDepthBuffer {
    BufferNumber buffer;
    std::uint64_t valid_raster = 0;  ///< fragments drawn
    Corners region;                  ///< as above
};

}  // namespace faster
