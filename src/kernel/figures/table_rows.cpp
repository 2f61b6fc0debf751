#include "kernel/figures/table_rows.hpp"

namespace faster {

namespace {

char const* kind_name(FifoKind kind) {
    switch (kind) {
        case FifoKind::automatic:
            return "auto";
        case FifoKind::shift_register:
            return "shift_register";
        case FifoKind::memory:
            return "memory";
    }
    return "";
}

Cycles port_conflict_cycles(CoreStatistics const& core, std::string const& bram) {
    Cycles conflicts = 0;
    for (LoopStatistics const& loop : core.loops)
        conflicts += loop.limited_by == bram ? loop.port_conflict_cycles : 0;
    return conflicts;
}

ModuleRow module_row(Machine const& machine, std::size_t core, std::size_t i, ProcessStatistics const& process) {
    ModuleRow row{core, machine.processes[i].name, process.cycles, {}, {}, machine.external_memory.has_value()};
    for (std::size_t const f : fifos_of(machine))
        if (machine.fifos[f].writer == i || machine.fifos[f].reader == i)
            row.stalls.push_back({machine.fifos[f].name, process.stalls[f]});
    for (std::size_t const b : brams_of(machine))
        row.port_conflicts.push_back({machine.memories[b].name, process.port_conflicts[b]});
    return row;
}

}  // namespace

std::vector<ModuleRow> module_rows(RunStatistics const& run) {
    std::vector<ModuleRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : modules_of(run.machine))
            rows.push_back(module_row(run.machine, core, i, run.cores[core].processes[i]));
    return rows;
}

std::vector<ModuleRow> module_sums(RunStatistics const& run) {
    std::vector<ModuleRow> rows;
    for (std::size_t const i : modules_of(run.machine))
        rows.push_back(module_row(run.machine, 0, i, process_sum(run, i)));
    return rows;
}

std::vector<FifoRow> fifo_rows(RunStatistics const& run) {
    std::vector<FifoRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : fifos_of(run.machine)) {
            FifoStatistics const& fifo = run.cores[core].fifos[i];
            rows.push_back({fifo, core, run.machine.fifos[i].name, kind_name(fifo.kind)});
        }
    return rows;
}

std::vector<LoopRow> loop_rows(RunStatistics const& run) {
    std::vector<LoopRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : loops_of(run.machine))
            rows.push_back({run.cores[core].loops[i], core, run.machine.processes[run.machine.loops[i].process].name,
                            run.machine.loops[i].name, run.machine.loops[i].is_listed});
    return rows;
}

std::vector<MemoryRow> memory_rows(RunStatistics const& run) {
    std::vector<MemoryRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core) {
        for (std::size_t const i : brams_of(run.machine)) {
            MachineMemory const& memory = run.machine.memories[i];
            rows.push_back({memory.shape, core, memory.name, port_conflict_cycles(run.cores[core], memory.name)});
        }
        for (LineBuffer const& buffer : run.machine.line_buffers)
            rows.push_back({{buffer.words, buffer.bits}, core, buffer.name, 0, false});
    }
    return rows;
}

}  // namespace faster
