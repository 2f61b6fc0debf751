#include "support/recorded_accesses.hpp"

#include "dataflow/tools/recording/fifo_state.hpp"
#include "dataflow/tools/recording/memory_trace.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

void for_each_access(std::vector<recording::RecordedCore> const& cores, AccessVisit const& visit) {
    using Kind = recording::Event::Kind;
    for (recording::RecordedCore const& core : cores) {
        recording::MemoryTrace memories(core);
        std::vector<recording::FifoState> fifos(core.fifos.begin(), core.fifos.end());
        recording::TokenValues read;
        recording::for_each_event({{core.core, core.spools}}, [&](recording::CoreEvent const& event) {
            if (event.event.kind == Kind::write)
                fifos[event.event.item].write(*event.fields);
            if (event.event.kind == Kind::read)
                fifos[event.event.item].read(read);
            visit(event, read, memories.take(event, read));
        });
    }
}

}  // namespace faster::testing
