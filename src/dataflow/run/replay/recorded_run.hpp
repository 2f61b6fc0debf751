#pragma once
#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/core/memory/memory_block.hpp"
#include "dataflow/core/memory/memory_load.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/operation_tape.hpp"
#include "dataflow/run/replay/sample_operations.hpp"

namespace dataflow::replay {

/// What a run had to do with an external memory: what the masters of its cores were told to fetch or to store. Says
/// nothing about bursts or time.
struct RecordedMemory {
    using Entries = std::vector<timing::MemoryEntry>;

    std::vector<std::vector<Entries>> entries;  ///< by sample of the run, and by master
    std::vector<timing::LoadedRange> loaded;    ///< before cycle 0
};

/// All that a run did, without the time it took: the function of the dataflow does not depend on its timing, nor on
/// which core scores which sample. Where it accesses FIFOs without waiting, what it found is recorded too, and a
/// retiming in which it would find something else is refused.
struct RecordedRun {
    std::unique_ptr<timing::CoreTiming> blueprint;  ///< FIFOs and processes that all cores have, nothing done yet
    std::deque<std::string> source_files;           ///< what the blueprint's source sites point to, if read from a file
    timing::Lead lead;  ///< of the machine that ran: the phrases on the tape are those of its group
    OperationTape tape;
    /// Of a run that got stuck: samples that are not on the tape, as far as they got. It can be looked at then, but not
    /// retimed.
    std::map<std::size_t, SampleOperations> unfinished;
    std::vector<Counters> counters;        ///< the samples' results
    std::optional<RecordedMemory> memory;  ///< of a machine with an external memory

    std::size_t samples() const {
        return unfinished.empty() ? tape.samples() : std::max(tape.samples(), unfinished.rbegin()->first + 1);
    }
};

}  // namespace dataflow::replay
