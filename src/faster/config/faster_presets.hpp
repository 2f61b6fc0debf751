#pragma once
#include <vector>

#include "dataflow/run/config/design.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// All of them, by name. The build makes them of the files of configs/architectures.
std::vector<Preset> const& faster_presets();

}  // namespace faster
