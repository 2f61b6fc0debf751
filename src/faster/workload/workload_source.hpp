#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// The stimulus a configuration asks for: its trace, or the workload it describes. A trace's size, window and fraction
/// bits replace those of `loaded`.
Stimulus load_stimulus(LoadedConfig& loaded);

/// A recorded depth image is seen through the default camera, as no key tells another; empty if one does.
std::string unset_camera_warning(LoadedConfig const& loaded);

/// What in it looks like a mistake of the workload, a line each.
std::vector<std::string> stimulus_warnings(Stimulus const& stimulus, LoadedConfig const& loaded);

}  // namespace faster
