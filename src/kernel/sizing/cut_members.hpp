#pragma once
#include <cstddef>
#include <vector>

#include "kernel/machine/core_ends.hpp"
#include "kernel/sizing/cut.hpp"
#include "kernel/timing/core_timing.hpp"

namespace faster::sizing {

using Members = std::vector<Cut::Member>;

/// The FIFOs that hold a core up. Of the critical path to a cycle of a process, with its trail:
Members members_of_path(timing::CoreTiming const& core, RunEnd const& end);
/// Of a deadlock. Everything else could have all the room it wants: what is full would be as full.
Members members_of_deadlock(timing::CoreTiming& core);

}  // namespace faster::sizing
