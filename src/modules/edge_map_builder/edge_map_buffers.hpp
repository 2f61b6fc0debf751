#pragma once
#include <memory>
#include <vector>

#include "faster/config/accelerator_config.hpp"
#include "modules/core/ping_pong.hpp"
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster {

/// Maps of a sample, `accelerator.edge_map.buffers` times.
using EdgeMapBuffers = PingPong<std::unique_ptr<datapath::EdgeMapPolicy>>;

inline EdgeMapBuffers make_edge_map_buffers(EdgeMapConfig const& config, int window) {
    std::vector<std::unique_ptr<datapath::EdgeMapPolicy>> maps(static_cast<std::size_t>(config.buffers));
    for (auto& map : maps)
        map = datapath::make_edge_map_policy(config.algorithm, window);
    return EdgeMapBuffers(std::move(maps));
}

}  // namespace faster
