#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "dataflow/core/memory/external_memory.hpp"
#include "dataflow/core/memory/served_burst.hpp"

namespace dataflow::recording {

/// What was recorded of an external memory.
struct RecordedBursts {
    timing::ExternalMemory shape;
    std::deque<timing::ServedBurst> bursts;   ///< in the order of asking
    std::vector<std::uint64_t> bytes_before;  ///< by port: of bursts before those
};

/// Takes down the bursts of a memory that somebody still asks for.
class MemoryRecorder {
  public:
    explicit MemoryRecorder(timing::ExternalMemory const& shape)
        : memory_{shape, {}, std::vector<std::uint64_t>(shape.ports)} {}

    void take(timing::ServedBurst const& burst) { memory_.bursts.push_back(burst); }
    /// Nobody will ask what happened before this cycle.
    void forget_before(Cycles cycle) {
        std::deque<timing::ServedBurst>& bursts = memory_.bursts;
        for (; !bursts.empty() && bursts.front().end() < cycle && bursts.front().end_ps < ps_of(cycle);
             bursts.pop_front())
            memory_.bytes_before[bursts.front().port] += bursts.front().beats * memory_.shape.port_bytes;
    }
    RecordedBursts const& recorded() const { return memory_; }

  private:
    Picoseconds ps_of(Cycles cycle) const { return Picoseconds{cycle} * memory_.shape.period_ps; }

    RecordedBursts memory_;
};

}  // namespace dataflow::recording
