#pragma once
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// What the critical path spends a cycle with.
enum class PathCause : std::size_t {
    busy,           ///< an operation, or an iteration at its target interval
    fill_drain,     ///< a pipeline fills or empties; a token goes through a flushing pipeline
    setup,          ///< a process prepares what its next loop works on
    port_conflict,  ///< a block RAM has too few ports for the target interval
    recurrence,     ///< a loop-carried dependence forbids the target interval
    read_latency,   ///< a token that is waited for goes through a FIFO
    backpressure,   ///< a token that was waited for has been read: its place in the FIFO is free a cycle later
    memory,         ///< the external memory has not brought what comes next, whoever keeps it busy
};

/// Cycles of the critical path that go into one thing.
struct PathRow {
    std::size_t module = 0;           ///< numbers of parts of the machine
    std::optional<std::size_t> loop;  ///< none: outside loops
    PathCause cause = PathCause::busy;
    std::optional<std::size_t> fifo;  ///< of read_latency and backpressure
    std::string bram;                 ///< of port_conflict
    Cycles cycles = 0;
    std::uint64_t crossings = 0;  ///< of read_latency and backpressure: how often the path leaves the module there
};

/// Along which operations total_cycles came about, in the core that ended last: from the last result's read back, each
/// process until it last waited, then the one that it waited for. The rows add up to total_cycles.
struct CriticalPath {
    std::size_t core = 0;
    std::vector<PathRow> rows;  ///< the largest first
};

}  // namespace dataflow
