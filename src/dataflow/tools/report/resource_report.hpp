#pragma once
#include <string>

#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow::report {

/// What a machine takes of the ZCU102's XCZU9EG, for people and for summary.json.
std::string resources_text(Machine const& machine);
Json resources_json(Machine const& machine);

}  // namespace dataflow::report
