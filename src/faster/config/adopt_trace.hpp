#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "faster/data/fixed_point.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// A stimulus trace determines the size of image and window, the fraction bits, and how many samples there are
/// (docs/formats.md#stimulus-trace): its values replace those of the configuration. Throws InputError if an override
/// explicitly asks for something else, or for any of the workload that the trace replaces.
void adopt_trace(LoadedConfig& loaded, int width, int height, int window, FractionBits const& fraction,
                 std::size_t samples);

/// The setting that stands for a trace which the command line names otherwise than by --set. `settings`: those of
/// --set, as KEY=VALUE. Throws InputError if one of them names another trace.
std::string setting_of_trace(std::string const& trace, std::vector<std::string> const& settings);

/// A table of poses determines how many samples there are. Throws InputError if an override says otherwise.
void adopt_poses(LoadedConfig& loaded, std::size_t count);

}  // namespace faster
