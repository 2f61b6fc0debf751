#pragma once
#include "kernel/figures/memory_traffic.hpp"
#include "kernel/machine/machine.hpp"

namespace faster::replay {

/// The figures of the external memory of so many cores.
MemoryTraffic collect_traffic(timing::MemorySystem const& memory, Machine const& machine, std::size_t cores);

}  // namespace faster::replay
