#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "dataflow/tools/recording/event_merge.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"

namespace dataflow::recording {

/// The accesses to memory ports that the events of one core stand for. None if the core tells no memory activity.
class MemoryTrace {
  public:
    explicit MemoryTrace(RecordedCore const& core);

    /// To be told of every event of the core; `fields` are those of the token that a read reads. Returns the accesses
    /// of an iteration, valid until the next call.
    std::vector<PortAccess> const& take(CoreEvent const& event, TokenValues const& fields);

  private:
    std::unique_ptr<MemoryActivity> activity_;  // may be null
    MemoryPorts ports_;
    std::vector<std::size_t> loops_;  // by process: the loop it has entered last
};

}  // namespace dataflow::recording
