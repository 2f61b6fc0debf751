#pragma once
#include <string>

#include "kernel/base/json.hpp"
#include "kernel/machine/machine.hpp"

namespace faster::report {

/// What a machine takes of the ZCU102's XCZU9EG, for people and for summary.json.
std::string resources_text(Machine const& machine);
Json resources_json(Machine const& machine);

}  // namespace faster::report
