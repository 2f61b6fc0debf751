#pragma once
#include <string>

#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow::report {

/// Longest path of each module against the machine's clock, estimated; for people a line for each that would not close.
/// Empty, or null, if the design does not tell.
std::string timing_text(Machine const& machine);
Json timing_json(Machine const& machine);

}  // namespace dataflow::report
