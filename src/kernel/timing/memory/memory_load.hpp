#pragma once
#include <vector>

#include "kernel/timing/memory/external_memory.hpp"
#include "kernel/timing/memory/memory_block.hpp"

namespace faster::timing {

/// How long it takes until ports have brought what memories on the chip are to hold, each its own, all from cycle 0 on;
/// beat by beat, as soon as they come. By port; nothing to bring: no blocks. 0 if no port brings anything.
Cycles cycles_of_load(ExternalMemory const& shape, std::vector<MemoryEntry> const& of_ports);

/// A range of bytes, a token for every beat.
MemoryBlock beats_of(ExternalMemory const& shape, std::uint64_t address, std::uint64_t bytes);

}  // namespace faster::timing
