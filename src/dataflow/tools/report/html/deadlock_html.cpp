#include "dataflow/tools/report/html/deadlock_html.hpp"

#include <algorithm>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/html/graph_data.hpp"
#include "dataflow/tools/report/html/page.hpp"
#include "dataflow/tools/report/html/run_data.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "dataflow/tools/report/summary.hpp"

namespace dataflow::report {

namespace {

std::uint64_t samples_of(RunStatistics const& run) {
    std::uint64_t samples = 0;
    for (CoreStatistics const& core : run.cores)
        samples += core.samples;
    return samples;
}

Json headline(RunStatistics const& run) {
    return {{"samples", samples_of(run)},   {"samples_done", run.samples.size()},
            {"cores", run.cores.size()},    {"cores_are", run.machine.cores_are},
            {"remark", run.machine.remark}, {"clock_mhz", run.machine.clock_mhz}};
}

Json fifo_row(Machine const& machine, std::size_t number, FifoStatistics const& fifo) {
    MachineFifo const& shape = machine.fifos[number];
    return {{"fifo", shape.name},
            {"writer", machine.processes[shape.writer].name},
            {"reader", machine.processes[shape.reader].name},
            {"occupancy", fifo.writes - fifo.reads},
            {"capacity", fifo.capacity},
            {"max_occupancy", fifo.max_occupancy},
            {"full_stall_cycles", fifo.full_stall_cycles},
            {"empty_stall_cycles", fifo.empty_stall_cycles},
            {"writes", fifo.writes},
            {"reads", fifo.reads}};
}

Json fifos(RunStatistics const& run) {
    Json rows = Json::array();
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : fifos_of(run.machine)) {
            rows.push_back(fifo_row(run.machine, i, run.cores[core].fifos[i]));
            rows.back()["core"] = core;
        }
    return rows;
}

/// The names of modules and loops, as the timeline's colours go by them.
Json modules(Machine const& machine) {
    Json rows = Json::array();
    for (std::size_t const i : modules_of(machine))
        rows.push_back({{"module", machine.processes[i].name}});
    return rows;
}

Json loops(Machine const& machine) {
    Json rows = Json::array();
    for (std::size_t const i : loops_of(machine))
        rows.push_back({{"core", 0},
                        {"module", machine.processes[machine.loops[i].process].name},
                        {"loop", machine.loops[i].name}});
    return rows;
}

Json timeline_rows(std::vector<PackedTimeline> const& timelines) {
    Json rows = Json::array();
    for (PackedTimeline const& timeline : timelines)
        rows.push_back(packed_timeline_json(timeline, {"one that got stuck"}));
    return rows;
}

TimelineSpan span_of(StuckProcess const& process, Machine const& machine, SampleTimeline const& timeline) {
    TimelineSpan span;
    span.module = machine.process(process.process);
    span.kind = process.waits_for_memory ? TimelineSpan::Kind::memory_stall
                : process.to_write       ? TimelineSpan::Kind::full_stall
                                         : TimelineSpan::Kind::empty_stall;
    span.item = process.waits_for_memory ? machine.fifos.size() : machine.fifo(process.fifo);
    span.begin = std::max(process.since_cycle, timeline.begin);
    span.end = timeline.end;
    span.count = span.end - span.begin;
    return span;
}

}  // namespace

SampleTimeline with_endless_waits(SampleTimeline timeline, RunStatistics const& run) {
    for (StuckProcess const& process : run.stuck)
        if (process.core == timeline.core && process.since_cycle < timeline.end)
            timeline.spans.push_back(span_of(process, run.machine, timeline));
    std::stable_sort(timeline.spans.begin(), timeline.spans.end(),
                     [](TimelineSpan const& a, TimelineSpan const& b) { return a.begin < b.begin; });
    return timeline;
}

Json deadlock_data(RunStatistics const& run) {
    Json data = deadlock_json(run);
    data["deeper"] = Json::array();
    for (StuckProcess const& wait : run.wait_cycle()) {
        std::string const key = fifo_key_name(wait.fifo, "depth");
        if (wait.to_write && !wait.waits_for_memory && find_key(key) != nullptr)
            data["deeper"].push_back(
                {{"fifo", wait.fifo}, {"key", key}, {"depth", run.machine.fifos[run.machine.fifo(wait.fifo)].depth}});
    }
    return data;
}

std::string deadlock_html(std::string const& title, RunCommand const& command, RunStatistics const& run,
                          std::vector<ResolvedKey> const& keys, std::vector<PackedTimeline> const& timelines) {
    Json data;
    data["format"] = "faster-deadlock";
    data["version"] = 1;
    data["program"] = program_name();
    data["command"] = command.words;
    data["settings"] = command.settings;
    data["headline"] = headline(run);
    data["deadlock"] = deadlock_data(run);
    data["cycle_classes"] = cycle_class_data(run.machine);
    data["graph"] = graph_data(run.machine);
    data["modules"] = modules(run.machine);
    data["loops"] = loops(run.machine);
    data["timelines"] = timeline_rows(timelines);
    data["fifos"] = fifos(run);
    data["configuration"] = configuration_data(keys);
    return filled_page(deadlock_page, title, made_by_html(configuration_hash(keys)), io::text_of(data));
}

}  // namespace dataflow::report
