#pragma once
#include "dataflow/run/figures/run_statistics.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// A core with a row for every part of a machine, as every run has them, that has done nothing.
inline CoreStatistics idle_core(Machine const& machine) {
    ProcessStatistics process;
    process.stalls.resize(machine.fifos.size());
    process.port_conflicts.resize(machine.memories.size());
    CoreStatistics core;
    core.fifos.resize(machine.fifos.size());
    core.loops.resize(machine.loops.size());
    core.processes.resize(machine.processes.size(), process);
    return core;
}

/// So many such cores.
inline RunStatistics idle_run(Machine const& machine, std::size_t cores) {
    RunStatistics run;
    run.machine = machine;
    run.cores.resize(cores, idle_core(machine));
    return run;
}

}  // namespace faster::testing
