#pragma once
#include "dataflow/run/replay/retime.hpp"

namespace dataflow::replay {

/// What a process does behind a non-blocking access depends on what that found. `are_over`: the cores have done all
/// that they can. Throws InputError if one of their processes would have found something else than was recorded, and
/// names the access.
void require_outcomes(Cores const& cores, bool are_over);

}  // namespace dataflow::replay
