#pragma once
#include <cstdint>
#include <vector>

#include "modules/core/depth.hpp"
#include "modules/core/ping_pong.hpp"

namespace faster {

/// A depth buffer, W x W words row by row, `accelerator.inlier_unit.buffers` times.
using DepthBuffers = PingPong<std::vector<std::uint16_t>>;

inline DepthBuffers make_depth_buffers(int buffers, std::size_t pixels) {
    return DepthBuffers(
        std::vector(static_cast<std::size_t>(buffers), std::vector<std::uint16_t>(pixels, far_depth_code)));
}

}  // namespace faster
