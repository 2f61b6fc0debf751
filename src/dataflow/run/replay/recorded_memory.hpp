#pragma once
#include <vector>

#include "dataflow/core/memory/memory_block.hpp"
#include "dataflow/core/memory/memory_load.hpp"

namespace dataflow::replay {

/// What a run had to do with an external memory: what the masters of its cores were told to fetch or to store. Says
/// nothing about bursts or time.
struct RecordedMemory {
    using Entries = std::vector<timing::MemoryEntry>;

    std::vector<std::vector<Entries>> entries;  ///< by sample of the run, and by master
    std::vector<timing::LoadedRange> loaded;    ///< before cycle 0
};

}  // namespace dataflow::replay
