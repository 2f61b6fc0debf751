#include "dataflow/tools/recording/memory_trace.hpp"

namespace dataflow::recording {

using Kind = Event::Kind;

MemoryTrace::MemoryTrace(RecordedCore const& core) : ports_(*core.machine), loops_(core.machine->processes.size()) {
    if (core.memory_activity)
        activity_ = core.memory_activity();
}

std::vector<PortAccess> const& MemoryTrace::take(CoreEvent const& core_event, TokenValues const& fields) {
    Event const& event = core_event.event;
    std::size_t& loop = loops_[core_event.process];
    ports_.begin_iteration(event.cycle);
    if (event.kind == Kind::enter)
        loop = event.item;
    else if (event.kind == Kind::read && activity_ != nullptr)
        activity_->token_read({core_event.process, event.item, fields, event.cycle});
    else if (event.kind == Kind::iterate && activity_ != nullptr)
        activity_->iterated({core_event.process, loop, event.value, event.cycle}, ports_);
    return ports_.accesses();
}

}  // namespace dataflow::recording
