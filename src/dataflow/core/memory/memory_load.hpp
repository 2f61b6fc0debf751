#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/core/memory/external_memory.hpp"
#include "dataflow/core/memory/memory_block.hpp"

namespace dataflow::timing {

/// What memories on the chip hold from before an iteration on.
struct LoadedRange {
    std::uint64_t address = 0;
    std::uint64_t bytes = 0;
    std::uint64_t copies = 0;  ///< that all cores share; 0: each core has its own
};

/// What each port brings for the memories of the cores behind it.
std::vector<MemoryEntry> loads_of_ports(ExternalMemory const& shape, std::vector<LoadedRange> const& ranges,
                                        std::size_t cores);

/// How long it takes until ports have brought what memories on the chip are to hold, each its own, all from cycle 0 on;
/// beat by beat, as soon as they come. By port; nothing to bring: no blocks. 0 if no port brings anything.
Cycles cycles_of_load(ExternalMemory const& shape, std::vector<MemoryEntry> const& of_ports);

/// A range of bytes, a token for every beat.
MemoryBlock beats_of(ExternalMemory const& shape, std::uint64_t address, std::uint64_t bytes);

}  // namespace dataflow::timing
