#include "dataflow/run/replay/collect.hpp"

#include <algorithm>

#include "dataflow/core/machine/core_ends.hpp"
#include "dataflow/run/replay/collect_traffic.hpp"

namespace dataflow::replay {

namespace {

FifoStatistics fifo_statistics(MachineFifo const& fifo, timing::FifoTiming const& timing) {
    FifoStatistics row;
    row.kind = fifo.kind;
    row.depth = fifo.depth;
    row.capacity = timing.shape().capacity;
    row.write_latency = timing.shape().write_latency;
    row.writes = timing.writes();
    row.reads = timing.reads();
    row.full_stall_cycles = timing.full_stall_cycles();
    row.empty_stall_cycles = timing.empty_stall_cycles();
    row.max_occupancy = std::min(timing.final_max_occupancy(), row.capacity);  // others wait in its pipeline
    return row;
}

/// Zeros for a loop that its process does not have.
timing::LoopCounters counters_of(MachineLoop const& loop, timing::CoreTiming const& core) {
    if (loop.process >= core.processes().size())
        return {};
    timing::ProcessTiming const& process = core.processes()[loop.process];
    for (unsigned i = 0; i < process.loops().size(); ++i)
        if (process.loops()[i].name == loop.name)
            return process.loop_counters(i);
    return {};
}

LoopStatistics loop_statistics(MachineLoop const& loop, timing::CoreTiming const& core) {
    timing::InitiationInterval const& interval = loop.interval;
    timing::LoopCounters const counters = counters_of(loop, core);
    LoopStatistics row;
    row.ii_target = interval.target;
    row.ii_recurrence = interval.recurrence;
    row.ii = interval.achieved;
    row.depth = loop.depth;
    row.entries = counters.entries;
    row.iterations = counters.iterations;
    row.port_conflict_cycles = counters.iterations * interval.port_conflict_per_iteration;
    row.interlock_cycles = counters.interlock_cycles;
    row.recurrence_cycles = counters.iterations * interval.recurrence_per_iteration + counters.interlock_cycles;
    row.limited_by = interval.limited_by;
    row.bram = interval.bram;
    row.bram_accesses = interval.bram_accesses;
    return row;
}

/// Works out where the cycles of the processes of one core went.
class CycleSorter {
  public:
    CycleSorter(timing::CoreTiming const& core, Machine const& machine, Cycles total_cycles)
        : core_(core), machine_(machine), total_cycles_(total_cycles) {}

    /// A process that drains a deep pipeline, or clears a map for a sample that does not come, may end after the last
    /// result was read; what lies beyond is not part of the run. One that the core does not have is idle.
    ProcessStatistics row_of(std::size_t number) const {
        ProcessStatistics row;
        row.stalls.resize(machine_.fifos.size());
        row.port_conflicts.resize(machine_.memories.size());
        if (number >= core_.processes().size()) {
            row[CycleClass::idle_after] = total_cycles_;
            return row;
        }
        timing::ProcessTiming const& process = core_.processes()[number];
        Cycles const end = std::min(process.end(), total_cycles_);
        if (process.idle_before_cycles() > end) {  // its first token comes after the last result
            row[CycleClass::idle_before] = end;
            return row;
        }
        Cycles const waited_beyond = add_stalls(process, end, row);
        add_loop_costs(process, row);
        row[CycleClass::setup] = cycles_of_setups(process);
        cut_off(process, process.end() - end - waited_beyond, row);
        if (row.sum() > end)  // it can only be iterations that wait for writes, of which nobody knows when they did
            row[CycleClass::recurrence] -= std::min(row[CycleClass::recurrence], row.sum() - end);
        take_off_stalls(process, row.sum() - std::min(end, row.sum()), row);
        row[CycleClass::busy] = end - std::min(end, row.sum());
        row[CycleClass::idle_after] = total_cycles_ - end;
        return row;
    }

  private:
    Cycles add_stalls(timing::ProcessTiming const& process, Cycles end, ProcessStatistics& row) const;
    void add_loop_costs(timing::ProcessTiming const& process, ProcessStatistics& row) const;
    Cycles cycles_of_setups(timing::ProcessTiming const& process) const;
    void cut_off(timing::ProcessTiming const& process, Cycles beyond, ProcessStatistics& row) const;
    void take_off_stalls(timing::ProcessTiming const& process, Cycles excess, ProcessStatistics& row) const;

    timing::CoreTiming const& core_;
    Machine const& machine_;
    Cycles total_cycles_;
};

/// By FIFO: what its reader or writer waited for. The wait for a process's first token is no stall. Returns the part
/// that lies beyond the end, which is not in the row.
Cycles CycleSorter::add_stalls(timing::ProcessTiming const& process, Cycles end, ProcessStatistics& row) const {
    Cycles all_beyond = 0;
    row[CycleClass::memory_stall] = process.memory_stall_cycles();
    row[CycleClass::idle_before] = process.idle_before_cycles();
    for (unsigned port = 0; port < process.port_count(); ++port) {
        timing::FifoTiming const& fifo = process.fifo(port);
        Cycles const beyond = process.end() > end ? process.waited_beyond(end, port) : 0;
        all_beyond += beyond;
        if (fifo.is_stream()) {
            row[CycleClass::memory_stall] -= beyond;
            continue;
        }
        bool const writes = process.writes(port);
        Cycles const all = writes ? fifo.full_stall_cycles() : fifo.empty_stall_cycles();
        Cycles const stall = all - process.idle_before_cycles(port) - beyond;
        row.stalls[core_.number_of(fifo)] += stall;
        row[writes ? CycleClass::full_stall : CycleClass::empty_stall] += stall;
    }
    return all_beyond;
}

void CycleSorter::add_loop_costs(timing::ProcessTiming const& process, ProcessStatistics& row) const {
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        timing::LoopCost const cost = process.loop_cost(i);
        row[CycleClass::port_conflict] += cost.port_conflict_cycles;
        row[CycleClass::recurrence] += cost.recurrence_cycles;
        row[CycleClass::fill_drain] += cost.fill_drain_cycles;
        if (cost.port_conflict_cycles > 0)
            row.port_conflicts[machine_.memory(process.loops()[i].interval.bram)] += cost.port_conflict_cycles;
    }
}

/// In which the process does nothing but prepare what its next loop works on.
Cycles CycleSorter::cycles_of_setups(timing::ProcessTiming const& process) const {
    MachineProcess const& described = machine_.processes[process.index()];
    Cycles const counted =
        described.setup_counter ? core_.fifos()[*described.setup_counter].writes() * described.setup_cycles : 0;
    return counted + process.awaited_setup_cycles();
}

/// Who waits behind the end more often than is kept (ProcessFigures::latest_waits) has stalls of more cycles than the
/// run.
void CycleSorter::take_off_stalls(timing::ProcessTiming const& process, Cycles excess, ProcessStatistics& row) const {
    for (auto port = static_cast<unsigned>(process.port_count()); port-- > 0 && excess > 0;) {
        if (process.fifo(port).is_stream())
            continue;
        Cycles& stall = row.stalls[core_.number_of(process.fifo(port))];
        Cycles const part = std::min(stall, excess);
        stall -= part;
        row[process.writes(port) ? CycleClass::full_stall : CycleClass::empty_stall] -= part;
        excess -= part;
    }
}

/// Takes the last `beyond` cycles of a process away, which are not part of the run: of the drain of its last loop, and
/// then of that loop's iterations, which end with what a port conflict and a recurrence cost.
void CycleSorter::cut_off(timing::ProcessTiming const& process, Cycles beyond, ProcessStatistics& row) const {
    Cycles const drain = std::min(row[CycleClass::fill_drain], beyond);
    row[CycleClass::fill_drain] -= drain;
    beyond -= drain;
    if (beyond == 0 || process.loops().empty())
        return;
    timing::InitiationInterval const& interval = process.loops()[process.current_loop()].interval;
    Cycles const iterations = beyond / interval.achieved;
    timing::IterationShares const all = timing::shares_of(interval, interval.achieved);
    timing::IterationShares const done =
        timing::shares_of(interval, interval.achieved - beyond % interval.achieved);  // of the one that is cut through
    Cycles const conflict =
        std::min(row[CycleClass::port_conflict], (iterations + 1) * all.port_conflict - done.port_conflict);
    row[CycleClass::port_conflict] -= conflict;
    if (conflict > 0)
        row.port_conflicts[machine_.memory(interval.bram)] -= conflict;
    row[CycleClass::recurrence] -=
        std::min(row[CycleClass::recurrence], (iterations + 1) * all.recurrence - done.recurrence);
}

CoreStatistics core_statistics(FinishedCore const& core, Machine const& machine) {
    CoreStatistics statistics;
    statistics.samples = core.share.count;
    for (std::size_t i = 0; i < machine.fifos.size(); ++i)
        statistics.fifos.push_back(fifo_statistics(machine.fifos[i], core.timing.fifos()[i]));
    for (MachineLoop const& loop : machine.loops)
        statistics.loops.push_back(loop_statistics(loop, core.timing));
    std::optional<RunEnd> const end = run_end(machine, core.timing);
    statistics.end_cycle = end ? end->cycle + 1 : 0;
    return statistics;
}

void add_samples(FinishedCore const& core, std::uint64_t index, Machine const& machine,
                 std::vector<SampleStatistics>& rows) {
    std::vector<Cycles> const begins = sample_begins(machine, core.timing);
    std::vector<Cycles> const& ends = sample_ends(machine, core.timing);
    for (std::size_t i = 0; i < std::min(begins.size(), ends.size()); ++i)
        rows.push_back({core.share.first + i, index, begins[i], ends[i], core.counters[i]});
}

/// Up to the deadlock.
void add_unfinished(FinishedCore const& core, std::uint64_t index, RunStatistics& run) {
    auto const is_of_core = [index](StuckProcess const& process) { return process.core == index; };
    std::vector<Cycles> const begins = sample_begins(run.machine, core.timing);
    std::size_t const done = sample_ends(run.machine, core.timing).size();
    if (begins.size() > done && std::any_of(run.stuck.begin(), run.stuck.end(), is_of_core))
        run.unfinished.push_back({core.share.first + done, index, begins[done], run.deadlock_cycle(), {}});
}

void add_stuck(std::vector<timing::BlockedProcess> const& waits, std::uint64_t index,
               std::vector<StuckProcess>& stuck) {
    for (timing::BlockedProcess const& wait : waits)
        stuck.push_back({index, wait.process, wait.position, wait.fifo, wait.to_write, wait.occupancy, wait.capacity,
                         wait.since, wait.other, wait.for_memory,
                         *wait.site.file == '\0' ? std::string()
                                                 : std::string(wait.site.file) + ":" + std::to_string(wait.site.line)});
}

/// Lookups charge a flushing pipeline ahead with the bubbles before its next token, which does not come here.
void take_back_bubbles(timing::CoreTiming const& core, timing::BlockedProcess const& wait,
                       std::vector<FifoStatistics>& fifos) {
    for (timing::ProcessTiming const& process : core.processes())
        for (unsigned port = 0; port < process.port_count(); ++port)
            if (process.flushes() && process.name() == wait.process && process.fifo(port).name() == wait.fifo)
                fifos[core.number_of(process.fifo(port))].empty_stall_cycles -= process.local_time() - wait.since;
}

}  // namespace

Cycles load_cycles(Machine const& machine, std::vector<timing::LoadedRange> loaded) {
    if (!machine.external_memory)
        return 0;
    std::uint64_t sharers = 1;
    for (MachineMemory const& memory : machine.memories)
        sharers = std::max(sharers, memory.sharers);
    for (timing::LoadedRange& range : loaded)
        if (range.copies > 0)
            range.copies = (machine.cores + sharers - 1) / sharers;
    timing::ExternalMemory shape = *machine.external_memory;
    shape.is_shared = true;  // whatever relaxation the cores are timed on
    return cycles_of_load(shape, loads_of_ports(shape, loaded, machine.cores));
}

RunStatistics collect(std::vector<FinishedCore> const& cores, Machine const& machine,
                      timing::MemorySystem const* memory, std::vector<timing::LoadedRange> const& loaded,
                      Cycles others) {
    RunStatistics run;
    run.total_cycles = others;
    if (memory != nullptr)
        run.memory = collect_traffic(*memory, machine, cores.size());
    run.machine = machine;
    for (FinishedCore const& core : cores) {
        auto const index = static_cast<std::uint64_t>(run.cores.size());
        std::vector<timing::BlockedProcess> const waits = core.timing.blocked();
        add_stuck(waits, index, run.stuck);
        add_samples(core, index, machine, run.samples);
        run.cores.push_back(core_statistics(core, machine));
        for (timing::BlockedProcess const& wait : waits)
            if (!wait.to_write)
                take_back_bubbles(core.timing, wait, run.cores.back().fifos);
        run.total_cycles = std::max(run.total_cycles, run.cores.back().end_cycle);
    }
    for (std::size_t k = 0; k < run.cores.size(); ++k) {
        CycleSorter const sorter(cores[k].timing, machine, run.total_cycles);
        for (std::size_t i = 0; i < machine.processes.size(); ++i)
            run.cores[k].processes.push_back(sorter.row_of(i));
        add_unfinished(cores[k], k, run);
    }
    if (memory != nullptr) {  // the cycles of the cores begin behind it
        run.load_cycles = load_cycles(machine, loaded);
        run.total_cycles += run.load_cycles;
    }
    return run;
}

}  // namespace dataflow::replay
