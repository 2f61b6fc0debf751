#pragma once
#include "common/stimulus.hpp"
#include "faster/workload_config.hpp"
#include "kernel/config/load_config.hpp"

namespace faster {

/// The stimulus a configuration asks for: its trace, or the workload it describes. A trace's size, window and fraction
/// bits replace those of `loaded`.
Stimulus load_stimulus(LoadedConfig& loaded);

/// What in it looks like a mistake of the workload, a line each.
std::vector<std::string> stimulus_warnings(Stimulus const& stimulus, WorkloadConfig const& config);

/// The same stimulus with its triangles as codes after the vertex transform, as a trace holds them.
Stimulus with_explicit_triangles(Stimulus stimulus);

}  // namespace faster
