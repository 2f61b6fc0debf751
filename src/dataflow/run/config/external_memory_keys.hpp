#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow {

/// Keys `accelerator.memory.*` of a design whose modules have memory streams: how the external memory works.
Keys external_memory_keys();

/// What none of them can say on its own, ready to print. For Design::complaints().
std::vector<std::string> external_memory_complaints(LoadedConfig const& loaded);

}  // namespace dataflow
