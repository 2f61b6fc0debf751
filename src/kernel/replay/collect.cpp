#include "kernel/replay/collect.hpp"

#include <algorithm>

#include "faster/rasterizer_design.hpp"
#include "modules/core_shapes.hpp"

namespace faster::retiming {

namespace {

FifoStatistics fifo_statistics(FifoId id, timing::FifoTiming const& timing, AcceleratorConfig const& config) {
    FifoStatistics row;
    row.kind = resolved_kind(config.fifo(id));
    row.depth = config.fifo(id).depth;
    row.capacity = timing.shape().capacity;
    row.write_latency = timing.shape().write_latency;
    row.writes = timing.writes();
    row.reads = timing.reads();
    row.full_stall_cycles = timing.full_stall_cycles();
    row.empty_stall_cycles = timing.empty_stall_cycles();
    row.max_occupancy = timing.max_occupancy();
    return row;
}

timing::LoopCounters counters_of(LoopId id, timing::ProcessTiming const& process) {
    char const* name = loop_names[index_of(id)].name;
    for (unsigned i = 0; i < process.loops().size(); ++i)
        if (process.loops()[i].name == name)
            return process.loop_counters(i);
    return {};
}

template <std::size_t N> std::size_t number_of(std::string const& name, std::array<char const*, N> const& names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

LoopStatistics loop_statistics(LoopId id, timing::CoreTiming const& core, AcceleratorConfig const& config) {
    timing::InitiationInterval const interval = initiation_interval(id, config);
    std::size_t const process = index_of(loop_names[index_of(id)].module);
    timing::LoopCounters const counters =
        process < core.processes().size() ? counters_of(id, core.processes()[process]) : timing::LoopCounters{};
    LoopStatistics row;
    row.ii_target = interval.target;
    row.ii_recurrence = interval.recurrence;
    row.ii = interval.achieved;
    row.depth = loop_depth(id, config);
    row.entries = counters.entries;
    row.iterations = counters.iterations;
    row.port_conflict_cycles = counters.iterations * interval.port_conflict_per_iteration;
    row.recurrence_cycles = counters.iterations * interval.recurrence_per_iteration;
    row.limited_by = interval.limited_by;
    row.bram = interval.bram;
    row.bram_accesses = interval.bram_accesses;
    return row;
}

/// By FIFO: what its reader or writer waited for. The wait for a process's first token is no stall.
void add_stalls(timing::ProcessTiming const& process, ProcessStatistics& row) {
    for (unsigned port = 0; port < process.port_count(); ++port) {
        timing::FifoTiming const& fifo = process.fifo(port);
        bool const writes = process.writes(port);
        Cycles const idle = port == process.first_port() ? process.idle_before_cycles() : 0;
        Cycles const stall = (writes ? fifo.full_stall_cycles() : fifo.empty_stall_cycles()) - idle;
        row.stalls[number_of(fifo.name(), fifo_names)] += stall;
        row[writes ? CycleClass::full_stall : CycleClass::empty_stall] += stall;
    }
    row[CycleClass::idle_before] = process.idle_before_cycles();
}

void add_loop_costs(timing::ProcessTiming const& process, ProcessStatistics& row) {
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        timing::LoopCost const cost = process.loop_cost(i);
        row[CycleClass::port_conflict] += cost.port_conflict_cycles;
        row[CycleClass::recurrence] += cost.recurrence_cycles;
        row[CycleClass::fill_drain] += cost.fill_drain_cycles;
        if (cost.port_conflict_cycles > 0)
            row.port_conflicts[number_of(process.loops()[i].interval.bram, bram_names)] += cost.port_conflict_cycles;
    }
}

/// Takes the last `beyond` cycles of a process away, which are not part of the run: of the drain of its last loop, and
/// then of that loop's iterations, which end with what a port conflict and a recurrence cost.
void cut_off(timing::ProcessTiming const& process, Cycles beyond, ProcessStatistics& row) {
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
        row.port_conflicts[number_of(interval.bram, bram_names)] -= conflict;
    row[CycleClass::recurrence] -=
        std::min(row[CycleClass::recurrence], (iterations + 1) * all.recurrence - done.recurrence);
}

/// A process that drains a deep pipeline, or clears a map for a sample that does not come, may end after the last
/// result was read; what lies beyond is not part of the run.
ProcessStatistics process_statistics(timing::ProcessTiming const& process, Cycles setup_cycles, Cycles total_cycles) {
    ProcessStatistics row;
    add_stalls(process, row);
    add_loop_costs(process, row);
    row[CycleClass::setup] = setup_cycles;
    Cycles const end = std::min(process.local_time(), total_cycles);
    cut_off(process, process.local_time() - end, row);
    row[CycleClass::busy] = end - row.sum();
    row[CycleClass::idle_after] = total_cycles - end;
    return row;
}

/// Cycles in which a process of a core does nothing but prepare triangles: the rasterizer, one area each.
Cycles cycles_of_setups(std::size_t process, timing::CoreTiming const& core, AcceleratorConfig const& config) {
    if (process != index_of(ModuleId::rasterizer))
        return 0;
    if (config.rasterizer.setup_overlap > 0)
        return core.processes()[process].awaited_setup_cycles();
    return core.fifos()[index_of(FifoId::area)].writes() * setup_cycles(config);
}

std::vector<Cycles> const& stamps_of(ModuleId module, timing::CoreTiming const& core) {
    return core.processes()[index_of(module)].stamps();
}

CoreStatistics core_statistics(FinishedCore const& core, AcceleratorConfig const& config) {
    CoreStatistics statistics;
    statistics.samples = core.share.count;
    for (std::size_t i = 0; i < fifo_count; ++i)
        statistics.fifos[i] = fifo_statistics(static_cast<FifoId>(i), core.timing.fifos()[i], config);
    for (std::size_t i = 0; i < loop_count; ++i)
        statistics.loops[i] = loop_statistics(static_cast<LoopId>(i), core.timing, config);
    auto const& ends = stamps_of(ModuleId::result_collector, core.timing);
    statistics.end_cycle = ends.empty() ? 0 : ends.back() + 1;
    return statistics;
}

void add_samples(FinishedCore const& core, std::uint64_t index, std::vector<SampleStatistics>& rows) {
    auto const& starts = stamps_of(ModuleId::rasterizer, core.timing);
    auto const& ends = stamps_of(ModuleId::result_collector, core.timing);
    for (std::size_t i = 0; i < std::min(starts.size(), ends.size()); ++i)
        rows.push_back({core.share.first + i, index, starts[i], ends[i], core.counters[i]});
}

void add_stuck(timing::CoreTiming& core, std::uint64_t index, std::vector<StuckProcess>& stuck) {
    for (timing::Wait const& wait : core.waits())
        stuck.push_back({index, wait.process, wait.position, wait.fifo, wait.to_write, wait.occupancy, wait.capacity,
                         wait.since, wait.other, std::string(wait.site.file) + ":" + std::to_string(wait.site.line)});
}

}  // namespace

RunStatistics collect(std::vector<FinishedCore> const& cores, AcceleratorConfig const& config) {
    RunStatistics run;
    run.parts = Parts(config);
    for (FinishedCore const& core : cores) {
        auto const index = static_cast<std::uint64_t>(run.cores.size());
        add_stuck(core.timing, index, run.stuck);
        add_samples(core, index, run.samples);
        run.cores.push_back(core_statistics(core, config));
        run.total_cycles = std::max(run.total_cycles, run.cores.back().end_cycle);
    }
    for (std::size_t k = 0; k < run.cores.size(); ++k)
        for (std::size_t i = 0; i < module_count; ++i) {
            timing::CoreTiming const& core = cores[k].timing;
            if (i < core.processes().size())
                run.cores[k].processes[i] =
                    process_statistics(core.processes()[i], cycles_of_setups(i, core, config), run.total_cycles);
            else
                run.cores[k].processes[i][CycleClass::idle_after] = run.total_cycles;
        }
    return run;
}

}  // namespace faster::retiming
