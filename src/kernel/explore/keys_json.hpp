#pragma once
#include <string>

#include "kernel/base/json.hpp"
#include "kernel/config/load_config.hpp"

namespace faster::explore {

/// The keys with which a recorded run may be retimed: what they mean, what they accept, and their values.
Json keys_json(RunConfig const& recorded);

/// A configuration file of a configuration: what differs from the defaults, so that a preset has said what it had to.
std::string exported_yaml(RunConfig const& config);

}  // namespace faster::explore
