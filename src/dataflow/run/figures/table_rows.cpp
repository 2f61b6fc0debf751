#include "dataflow/run/figures/table_rows.hpp"

#include <algorithm>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/integer_bits.hpp"

namespace dataflow {

namespace {

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

std::uint64_t DependenceRow::hazards() const {
    std::uint64_t sum = 0;
    for (std::size_t distance = 1; distance < counts.size(); ++distance)
        sum += dependence.is_hazard(distance, ii) ? counts[distance] : 0;
    return sum;
}

std::uint64_t DependenceRow::comparators() const { return dependence.reads * dependence.writes * dependence.reach(ii); }

std::uint64_t DependenceRow::register_bits() const {
    bool const keeps_words = dependence.handling == HazardHandling::forward;
    return dependence.writes * dependence.reach(ii) * (address_bits + (keeps_words ? word_bits : 0) + 1);
}

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
            rows.push_back({fifo, core, run.machine.fifos[i].name, std::string(enumerator_name(fifo.kind))});
        }
    return rows;
}

std::vector<LoopRow> loop_rows(RunStatistics const& run) {
    std::vector<LoopRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : loops_of(run.machine))
            rows.push_back({run.cores[core].loops[i], core, run.machine.processes[run.machine.loops[i].process].name,
                            run.machine.loops[i].name});
    return rows;
}

std::vector<DependenceRow> dependence_rows(RunStatistics const& run) {
    std::vector<DependenceRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (DependenceStatistics const& seen : run.cores[core].dependences) {
            MachineLoop const& loop = run.machine.loops[seen.loop];
            MachineDependence const& dependence = loop.dependences[seen.number];
            MachineMemory const& memory = run.machine.memories[dependence.memory];
            rows.push_back({core, run.machine.processes[loop.process].name, loop.name, memory.name,
                            loop.interval.achieved, dependence, bits_for(memory.words - 1),
                            static_cast<unsigned>(memory.shape.bits), seen.smallest, seen.counts,
                            run.cores[core].loops[seen.loop].interlock_cycles});
        }
    return rows;
}

std::vector<DependenceRow> dependence_sums(RunStatistics const& run) {
    std::vector<DependenceRow> sums;
    for (DependenceRow const& row : dependence_rows(run)) {
        auto const is_same = [&row](DependenceRow const& sum) {
            return sum.name() == row.name() && sum.bram == row.bram;
        };
        auto const sum = std::find_if(sums.begin(), sums.end(), is_same);
        if (sum == sums.end()) {
            sums.push_back(row);
            continue;
        }
        if (row.smallest != 0 && (sum->smallest == 0 || row.smallest < sum->smallest))
            sum->smallest = row.smallest;
        for (std::size_t distance = 0; distance < row.counts.size(); ++distance)
            sum->counts[distance] += row.counts[distance];
        sum->interlock_cycles += row.interlock_cycles;
    }
    return sums;
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

}  // namespace dataflow
