#include "support/example_run.hpp"

#include <algorithm>
#include <random>

#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/counters.hpp"
#include "support/idle_run.hpp"
#include "support/parts.hpp"
#include "support/raster_machine.hpp"

namespace faster::test {

namespace {

using testing::BramId;
using testing::FifoId;
using testing::LoopId;
using testing::ModuleId;

constexpr Cycles total_cycles = 1000000;

/// Two cores of the default design.
Machine const& example_machine() {
    static Machine const machine = [] {
        AcceleratorConfig config;
        config.cores = 2;
        return testing::raster_machine(config);
    }();
    return machine;
}

ProcessStatistics example_process(std::size_t module) {
    Machine const& machine = example_machine();
    ProcessStatistics process = testing::idle_core(machine).processes[module];
    process[CycleClass::busy] = 100000 + 30000 * module;
    process[CycleClass::fill_drain] = 20000;
    process[CycleClass::idle_before] = 1000 * module;
    process[CycleClass::idle_after] = 5000;
    Cycles left = total_cycles - process.sum();
    for (std::size_t const f : fifos_of(machine)) {
        bool const reads = machine.fifos[f].reader == module;
        if (!reads && machine.fifos[f].writer != module)
            continue;
        process.stalls[f] = left / 2;
        process[reads ? CycleClass::empty_stall : CycleClass::full_stall] += left / 2;
        left -= left / 2;
    }
    process[CycleClass::port_conflict] = left;
    process.port_conflicts[index_of(BramId::depth_buffer)] = left;
    return process;
}

CoreStatistics example_core() {
    Machine const& machine = example_machine();
    CoreStatistics core = testing::idle_core(machine);
    core.end_cycle = total_cycles;
    for (std::size_t const i : modules_of(machine))
        core.processes[i] = example_process(i);
    for (std::size_t const i : fifos_of(machine))
        core.fifos[i] = {FifoKind::shift_register, 2, 2, 1, 1000 * (i + 1), 1000 * (i + 1), 70 * i, 900 - 60 * i, 2};
    for (std::size_t const i : loops_of(machine))
        core.loops[i] = {1, 1, 1, 3 + i, 10, 1000 * (i + 1), 0, 0, "", "", 0};
    LoopStatistics& sweep = core.loops[index_of(LoopId::sweep)];
    sweep.ii = 3;
    sweep.port_conflict_cycles = 18000;
    sweep.limited_by = sweep.bram = name_of(BramId::depth_buffer);
    sweep.bram_accesses = 5;
    return core;
}

/// Writes down one module after the other; the engine gives lengths that look like those of triangles.
class Sketch {
  public:
    explicit Sketch(SampleTimeline& timeline) : timeline_(timeline) {}

    void loop(LoopId id, Cycles begin, Cycles end) {
        add(index_of(id.module), TimelineSpan::Kind::loop, index_of(id), begin, end);
    }
    void empty(FifoId id, Cycles begin, Cycles end) {
        add(example_machine().fifos[index_of(id)].reader, TimelineSpan::Kind::empty_stall, index_of(id), begin, end);
    }
    void full(FifoId id, Cycles begin, Cycles end) {
        add(example_machine().fifos[index_of(id)].writer, TimelineSpan::Kind::full_stall, index_of(id), begin, end);
    }
    Cycles between(Cycles low, Cycles high) { return low + random_() % (high - low); }
    void sort() {
        std::stable_sort(timeline_.spans.begin(), timeline_.spans.end(),
                         [](TimelineSpan const& a, TimelineSpan const& b) { return a.begin < b.begin; });
    }

  private:
    void add(std::size_t module, TimelineSpan::Kind kind, std::size_t item, Cycles begin, Cycles end) {
        Cycles const count = kind == TimelineSpan::Kind::loop ? (end - begin) / 2 : end - begin;
        timeline_.spans.push_back({module, kind, item, timeline_.begin + begin, timeline_.begin + end, count});
    }

    SampleTimeline& timeline_;
    std::mt19937 random_{7};  // NOLINT: the same sketch every time
};

constexpr Cycles clear_cycles = 40000;
constexpr Cycles last_triangle = 220000;
constexpr Cycles sample_cycles = 345000;

/// One triangle after the other, with the reader of its fragments starved between them.
void sketch_triangles(Sketch& sketch) {
    for (Cycles cycle = clear_cycles; cycle < last_triangle;) {
        Cycles const scan = sketch.between(60, 500), setup = sketch.between(30, 60);
        sketch.loop(LoopId::scan, cycle + setup, cycle + setup + scan);
        if (scan > 200)
            sketch.full(FifoId::edge_token, cycle + setup + scan / 3, cycle + setup + scan / 2);
        sketch.loop(LoopId::fragment, cycle + setup + 20, cycle + setup + scan + 20);
        sketch.empty(FifoId::command, cycle + setup + 20, cycle + setup + 20 + scan / 4);
        cycle += setup + scan;
    }
}

void sketch_occupancy(SampleTimeline& timeline, Sketch& sketch) {
    for (FifoId const id : {FifoId::vertex, FifoId::command, FifoId::edge_token, FifoId::observed_depth}) {
        std::vector<OccupancyPoint>& points = timeline.occupancy[index_of(id)];
        std::uint64_t tokens = 0;
        for (Cycles cycle = timeline.begin; cycle < timeline.end; cycle += sketch.between(50, 3000)) {
            bool const in_triangles = cycle - timeline.begin > clear_cycles && cycle - timeline.begin < last_triangle;
            tokens = in_triangles ? sketch.between(0, 3) : (id == FifoId::observed_depth ? 2U : 0U);
            points.push_back({cycle, tokens});
        }
    }
}

CriticalPath example_path() {
    CriticalPath path;
    path.core = 1;
    auto const add = [&path](ModuleId module, std::optional<LoopId> loop, PathCause cause, Cycles cycles) -> PathRow& {
        PathRow row;
        row.module = index_of(module);
        if (loop)
            row.loop = index_of(*loop);
        row.cause = cause;
        row.cycles = cycles;
        return path.rows.emplace_back(row);
    };
    add(ModuleId::inlier_unit, LoopId::sweep, PathCause::busy, 600000);
    add(ModuleId::inlier_unit, LoopId::sweep, PathCause::port_conflict, 300000).bram = name_of(BramId::depth_buffer);
    add(ModuleId::rasterizer, std::nullopt, PathCause::setup, 90000);
    PathRow& crossing = add(ModuleId::inlier_unit, LoopId::fragment, PathCause::read_latency, 10000);
    crossing.fifo = index_of(FifoId::command);
    crossing.crossings = 10000;
    return path;
}

std::vector<Sensitivity> example_sensitivities() {
    return {{"accelerator.fifos.command.depth", 2, {true, true, 0}, {true, false, total_cycles - 500}},
            {"accelerator.fifos.vertex.depth", 1, {false, false, 0}, {true, false, total_cycles}},
            {"accelerator.loops.rasterizer.setup.depth",
             12,
             {true, false, total_cycles - 7500},
             {true, false, total_cycles + 7500}}};
}

}  // namespace

RunStatistics example_run() {
    RunStatistics run;
    run.machine = example_machine();
    run.total_cycles = total_cycles;
    run.cores = {example_core(), example_core()};
    run.cores[0].samples = 3;
    run.cores[1].samples = 2;
    for (std::uint64_t sample = 0; sample < 5; ++sample) {
        Cycles const begin = 1 + sample * 150000;
        run.samples.push_back({sample, sample / 3, begin, begin + sample_cycles - 1 + 1000 * sample,
                               Counters(testing::counter_names.size())});
    }
    run.critical_path = example_path();
    run.sensitivities = example_sensitivities();
    return run;
}

SampleTimeline example_timeline(std::uint64_t core, std::uint64_t sample, Cycles begin) {
    SampleTimeline timeline;
    timeline.core = core;
    timeline.sample = sample;
    timeline.begin = begin;
    timeline.end = begin + sample_cycles;
    timeline.occupancy.resize(example_machine().fifos.size());
    Sketch sketch(timeline);
    sketch.loop(LoopId::vertex, 0, last_triangle);
    sketch.full(FifoId::vertex, 60, last_triangle - 500);
    sketch.loop(LoopId::edge_clear, 0, clear_cycles);
    sketch.loop(LoopId::depth_clear, 0, clear_cycles);
    sketch.full(FifoId::command, 100, clear_cycles);
    sketch.loop(LoopId::read, 10, sample_cycles - 100);
    sketch.full(FifoId::observed_depth, 20, last_triangle);
    sketch_triangles(sketch);
    sketch.loop(LoopId::token, clear_cycles, last_triangle + 2000);
    sketch.empty(FifoId::edge_token, last_triangle - 9000, last_triangle);
    sketch.loop(LoopId::output, last_triangle + 2000, sample_cycles - 50);
    sketch.full(FifoId::edge_map, last_triangle + 2100, sample_cycles - 60);
    sketch.empty(FifoId::area_reciprocal, last_triangle + 600, last_triangle + 2000);
    sketch.loop(LoopId::sweep, last_triangle + 2000, sample_cycles - 10);
    sketch.empty(FifoId::result, 0, sample_cycles - 1);
    sketch.sort();
    sketch_occupancy(timeline, sketch);
    return timeline;
}

report::PackedTimeline packed_example_timeline(std::uint64_t core, std::uint64_t sample, Cycles begin) {
    return report::packed_timeline(example_machine(), example_timeline(core, sample, begin), 100'000);
}

std::vector<ResolvedKey> example_keys() {
    RunConfig config;
    workload_of(config).trace = hostile_text;
    accelerator_of(config).cores = 2;
    return resolved_keys(config);
}

}  // namespace faster::test
