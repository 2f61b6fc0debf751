#pragma once
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/figures/memory_traffic.hpp"

namespace dataflow::replay {

/// The figures of the external memory of so many cores.
MemoryTraffic collect_traffic(timing::MemorySystem const& memory, Machine const& machine, std::size_t cores);

}  // namespace dataflow::replay
