#include "dataflow/tools/sizing/relaxation.hpp"

namespace dataflow::sizing {

std::vector<std::size_t> freezing_fifos(Machine const& machine) {
    std::vector<std::size_t> freezing;
    for (std::size_t const i : fifos_of(machine))
        if (machine.fifos[i].shape().flushing_stages > 0)
            freezing.push_back(i);
    return freezing;
}

bool shares_memory(Machine const& machine) { return machine.external_memory && machine.external_memory->is_shared; }

Machine relaxed(Machine machine) {
    for (std::size_t const i : freezing_fifos(machine))
        machine.fifos[i].when_full = WhenFull::squeeze;
    if (machine.external_memory)
        machine.external_memory->is_shared = false;
    return machine;
}

}  // namespace dataflow::sizing
