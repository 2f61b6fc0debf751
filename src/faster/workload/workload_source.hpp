#pragma once
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/workload_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// The stimulus a configuration asks for: its trace, or the workload it describes. A trace's size, window and fraction
/// bits replace those of `loaded`.
Stimulus load_stimulus(LoadedConfig& loaded);

/// What in it looks like a mistake of the workload, a line each.
std::vector<std::string> stimulus_warnings(Stimulus const& stimulus, WorkloadConfig const& config);

}  // namespace faster
