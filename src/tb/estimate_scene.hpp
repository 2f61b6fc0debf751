#pragma once
#include "estimation/scene.hpp"
#include "kernel/config/load_config.hpp"

namespace faster {

/// The scene of a configuration: its workload without samples, whose pose is the truth, and the box of
/// `estimator.box.*`. Throws InputError for a trace, no samples, and a box outside the image.
estimation::Scene configured_scene(LoadedConfig const& loaded);

}  // namespace faster
