#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "dataflow/core/machine/module_description.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What the branches of a loop do to a memory, one of which an iteration takes: each is an access pattern that its
/// initiation interval has to provide for, so the largest decides.
inline LoopDescription& add_branches(LoopDescription& loop, std::string const& memory,
                                     std::vector<AccessPattern> const& branches) {
    for (AccessPattern const& branch : branches)
        if (branch.accesses() > 0)
            loop.accesses_memory(memory, branch);
    return loop;
}

/// Stages of a loop in which it reads a memory, and writes what depends on that.
struct AccessStages {
    Cycles read;
    Cycles write;
};

/// Of branches whose dependences between iterations are looked after: reads and writes are those of the branch that has
/// most of them, which need not be the same for both.
inline LoopDescription& add_branches(LoopDescription& loop, std::string const& memory,
                                     std::vector<AccessPattern> const& branches, AccessStages stages) {
    std::size_t reads = 0;
    std::size_t writes = 0;
    for (AccessPattern const& branch : branches) {
        reads = std::max(reads, branch.reads.size());
        writes = std::max(writes, branch.writes.size());
    }
    return add_branches(loop, memory, branches).in_stages({memory, stages.read, stages.write, reads, writes});
}

/// Makes each branch of a loop one that works on `lanes` pixels of a row.
inline void widen_branches(LoopDescription& loop, int lanes) {
    for (MemoryAccess& access : loop.accesses)
        access.pattern = widened(access.pattern, lanes);
    for (MemoryStages& stages : loop.memory_stages) {
        stages.reads *= static_cast<std::uint64_t>(lanes);
        stages.writes *= static_cast<std::uint64_t>(lanes);
    }
}

}  // namespace faster
