#pragma once
#include <cstddef>
#include <string>

#include "faster/config/accelerator_config.hpp"

namespace faster {

/// How a block RAM is cleared before a sample.
MapClearing clearing_of(std::string const& memory, AcceleratorConfig const& config);

/// Iterations of edge_map_builder.clear and inlier_unit.clear; 0: the loop is not there. `window`: side of the maps
/// [px].
std::size_t edge_clear_iterations(AcceleratorConfig const& config, int window);
std::size_t depth_clear_iterations(AcceleratorConfig const& config, int window);

}  // namespace faster
