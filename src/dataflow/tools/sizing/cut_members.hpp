#pragma once
#include <vector>

#include "dataflow/core/machine/core_ends.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/tools/sizing/cut.hpp"

namespace dataflow::sizing {

using Members = std::vector<Cut::Member>;

/// The FIFOs that hold a core up. Of the critical path to a cycle of a process, with its trail:
Members members_of_path(timing::CoreTiming const& core, RunEnd const& end);
/// Of a deadlock. Everything else could have all the room it wants: what is full would be as full.
Members members_of_deadlock(timing::CoreTiming& core);

}  // namespace dataflow::sizing
