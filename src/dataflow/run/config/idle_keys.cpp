#include "dataflow/run/config/idle_keys.hpp"

#include <algorithm>

#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_names.hpp"

namespace dataflow {
namespace {

template <class Parts, class NameOfKey> void add_absent(Parts const& parts, NameOfKey name_of_key, IdleKeys& idle) {
    for (auto const& part : parts)
        if (!part.is_present)
            idle.add(name_of_key(part.name, ""), part.decided_by);
}

/// A loop's keys are there as long as they time a loop, whichever process it runs in.
void add_absent_loops(Machine const& machine, IdleKeys& idle) {
    for (std::size_t i = 0; i < machine.loops.size(); ++i) {
        std::string const name = machine.loop_name(i);
        bool const is_needed =
            std::any_of(machine.loops.begin(), machine.loops.end(),
                        [&name](MachineLoop const& loop) { return loop.is_present && loop.timed_by == name; });
        if (machine.loops[i].timed_by == name && !is_needed)
            idle.add(loop_key_name(name, ""), machine.loops[i].decided_by);
    }
}

}  // namespace

IdleKeys idle_keys(RunConfig const& config) {
    Machine const machine = machine_of(config);
    IdleKeys idle;
    add_absent(machine.fifos, fifo_key_name, idle);
    add_absent_loops(machine, idle);
    add_absent(machine.memories, bram_key_name, idle);
    add_absent(machine.processes, module_key_name, idle);
    for (MachineProcess const& process : machine.processes)
        if (!process.is_present)
            idle.add(setup_key_name(process.name), process.decided_by);
    idle.add(design().idle_keys(config));
    return idle;
}

}  // namespace dataflow
