#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"

namespace dataflow::events {

/// A recorded run's configuration with overrides, each "a.b.c=value", in their order. Throws InputError for bad ones,
/// and for a key that decides about more than time: it names the key and says why.
LoadedConfig retimed_config(LoadedConfig const& recorded, std::vector<std::string> const& overrides);

}  // namespace dataflow::events
