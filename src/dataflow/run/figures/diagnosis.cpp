#include "dataflow/run/figures/diagnosis.hpp"

#include <algorithm>

namespace dataflow {

namespace {

Cycles waits_of(ProcessStatistics const& process) {
    return process[CycleClass::empty_stall] + process[CycleClass::full_stall] + process[CycleClass::memory_stall] +
           process[CycleClass::idle_before] + process[CycleClass::idle_after];
}

std::size_t least_waiting(CoreStatistics const& core, Machine const& machine) {
    std::vector<std::size_t> const modules = modules_of(machine);
    auto const waits_less = [&core](std::size_t a, std::size_t b) {
        return waits_of(core.processes[a]) < waits_of(core.processes[b]);
    };
    return *std::min_element(modules.begin(), modules.end(), waits_less);
}

Cause loop_cause(LoopStatistics const& row, std::size_t loop) {
    Cause cause;
    cause.item = loop;
    cause.port_conflict = row.port_conflict_cycles;
    cause.interlock = row.interlock_cycles;
    cause.cycles = row.iterations * row.ii + row.interlock_cycles;
    return cause;
}

}  // namespace

Diagnosis diagnose(RunStatistics const& run) {
    Diagnosis diagnosis;
    if (run.core_cycles() == 0)
        return diagnosis;
    diagnosis.core = run.last_core();
    CoreStatistics const& core = run.cores[diagnosis.core];
    diagnosis.module = least_waiting(core, run.machine);
    diagnosis.cycles = run.core_cycles();
    ProcessStatistics const& process = core.processes[diagnosis.module];
    diagnosis.waits = waits_of(process);
    Cycles left = diagnosis.cycles;
    auto const add = [&](Cause cause) {
        cause.cycles = std::min(cause.cycles, left);  // a loop shorter than its II ends before its last iteration does
        left -= cause.cycles;
        if (cause.cycles > 0)
            diagnosis.causes.push_back(cause);
    };
    for (std::size_t f = 0; f < process.stalls.size(); ++f)
        add({Cause::Kind::stall, f, process.stalls[f]});
    add({Cause::Kind::memory_stall, 0, process[CycleClass::memory_stall]});
    add({Cause::Kind::setup, 0, process[CycleClass::setup]});
    add({Cause::Kind::fill_drain, 0, process[CycleClass::fill_drain]});
    add({Cause::Kind::idle, 0, process[CycleClass::idle_before] + process[CycleClass::idle_after]});
    for (std::size_t i = 0; i < core.loops.size(); ++i)
        if (run.machine.loops[i].process == diagnosis.module)
            add(loop_cause(core.loops[i], i));
    add({Cause::Kind::between_loops, 0, left});
    std::stable_sort(diagnosis.causes.begin(), diagnosis.causes.end(),
                     [](Cause const& a, Cause const& b) { return a.cycles > b.cycles; });
    return diagnosis;
}

}  // namespace dataflow
