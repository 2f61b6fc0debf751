#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What no key of FASTER can say on its own, ready to print: see docs/function.md#formats.
std::vector<std::string> faster_complaints(LoadedConfig const& loaded);

}  // namespace faster
