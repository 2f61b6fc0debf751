#include "simulation/collect.hpp"

#include <algorithm>

#include "modules/core_shapes.hpp"

namespace faster {

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

LoopStatistics loop_statistics(LoopId id, timing::CoreTiming const& core, AcceleratorConfig const& config) {
    timing::InitiationInterval const interval = initiation_interval(id, config);
    timing::LoopCounters const counters = counters_of(id, core.processes()[index_of(loop_names[index_of(id)].module)]);
    LoopStatistics row;
    row.ii_target = interval.target;
    row.ii_recurrence = interval.recurrence;
    row.ii = interval.achieved;
    row.depth = config.loop(id).depth;
    row.entries = counters.entries;
    row.iterations = counters.iterations;
    row.port_conflict_cycles = counters.iterations * interval.port_conflict_per_iteration;
    row.recurrence_cycles = counters.iterations * interval.recurrence_per_iteration;
    row.limited_by = interval.limited_by;
    row.bram = interval.bram;
    return row;
}

/// A process that drains a deep pipeline may end after the last result was read; what lies beyond is not part of the
/// run.
ProcessStatistics process_statistics(timing::ProcessTiming const& process, Cycles total_cycles) {
    timing::ProcessCounters const& counters = process.counters();
    ProcessStatistics row;
    row.empty_stall_cycles = counters.empty_stall_cycles;
    row.full_stall_cycles = counters.full_stall_cycles;
    row.port_conflict_cycles = counters.port_conflict_cycles;
    row.recurrence_cycles = counters.recurrence_cycles;
    Cycles const end = std::min(process.local_time(), total_cycles);
    row.idle_cycles = total_cycles - end;
    row.busy_cycles = end - (row.sum() - row.idle_cycles);
    return row;
}

CoreStatistics core_statistics(RasterCore const& core, AcceleratorConfig const& config) {
    CoreStatistics statistics;
    statistics.samples = core.share().count;
    for (std::size_t i = 0; i < fifo_count; ++i)
        statistics.fifos[i] = fifo_statistics(static_cast<FifoId>(i), core.timing().fifos()[i], config);
    for (std::size_t i = 0; i < loop_count; ++i)
        statistics.loops[i] = loop_statistics(static_cast<LoopId>(i), core.timing(), config);
    auto const& ends = core.result_collector.clock().timing().stamps();
    statistics.end_cycle = ends.empty() ? 0 : ends.back() + 1;
    return statistics;
}

void add_samples(RasterCore const& core, std::uint64_t index, std::vector<SampleStatistics>& rows) {
    auto const& starts = core.rasterizer.clock().timing().stamps();
    auto const& ends = core.result_collector.clock().timing().stamps();
    for (std::size_t i = 0; i < ends.size(); ++i)
        rows.push_back({core.share().first + i, index, starts[i], ends[i], core.result_collector.results()[i]});
}

void add_stuck(RasterCore& core, std::uint64_t index, std::vector<StuckProcess>& stuck) {
    for (timing::Wait const& wait : core.timing().waits())
        stuck.push_back({index, wait.process, wait.position, wait.fifo, wait.to_write, wait.occupancy, wait.capacity,
                         wait.since, wait.other});
}

}  // namespace

RunStatistics collect(Accelerator const& accelerator, AcceleratorConfig const& config, Stimulus const& stimulus) {
    RunStatistics run;
    run.samples.reserve(stimulus.samples.size());
    for (auto const& core : accelerator.cores()) {
        auto const index = static_cast<std::uint64_t>(run.cores.size());
        add_stuck(*core, index, run.stuck);
        add_samples(*core, index, run.samples);
        run.cores.push_back(core_statistics(*core, config));
        run.total_cycles = std::max(run.total_cycles, run.cores.back().end_cycle);
    }
    for (std::size_t k = 0; k < run.cores.size(); ++k)
        for (std::size_t i = 0; i < module_count; ++i)
            run.cores[k].processes[i] =
                process_statistics(accelerator.cores()[k]->timing().processes()[i], run.total_cycles);
    return run;
}

}  // namespace faster
