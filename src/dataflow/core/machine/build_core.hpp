#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/time/core_timing.hpp"

namespace dataflow {

/// Gives an empty core what a machine's cores consist of: FIFOs, ends of the external memory, and processes with their
/// ports and loops, in the machine's order. A process's ports are its ends of FIFOs, and then the one of the memory,
/// though a step accesses that first: so the others have the same numbers with any memory.
///
/// `streams`: the ends of the memory that the core gets. What was recorded with an external memory asks for its own,
/// also where the machine has an ideal one.
void build_core(timing::CoreTiming& core, Machine const& machine, std::vector<std::size_t> const& streams);
/// With the ends that the machine has.
void build_core(timing::CoreTiming& core, Machine const& machine);

}  // namespace dataflow
