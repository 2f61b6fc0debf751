#include "kernel/report/html/report_data.hpp"

#include <cmath>

#include "kernel/base/files/json_file.hpp"
#include "kernel/config/plain_value.hpp"
#include "kernel/figures/table_rows.hpp"
#include "kernel/report/critical_path_report.hpp"
#include "kernel/report/diagnosis_text.hpp"
#include "kernel/report/hazard_report.hpp"
#include "kernel/report/html/html_text.hpp"
#include "kernel/report/html/latency_histogram.hpp"
#include "kernel/report/html/timeline_view.hpp"
#include "kernel/report/json_rows.hpp"
#include "kernel/report/latencies.hpp"
#include "kernel/report/memory_traffic_report.hpp"
#include "kernel/report/sensitivity_report.hpp"
#include "kernel/report/summary.hpp"

namespace faster::report {

namespace {

Json headline(HtmlReportInput const& input) {
    return {{"total_cycles", input.run.total_cycles},
            {"milliseconds", input.run.machine.milliseconds(input.run.total_cycles)},
            {"samples", input.run.samples.size()},
            {"cores", input.run.cores.size()},
            {"cores_are", input.run.machine.cores_are},
            {"remark", input.run.machine.remark},
            {"clock_mhz", input.run.machine.clock_mhz}};
}

Json modules(RunStatistics const& run) {
    Json rows = Json::array();
    for (std::size_t const i : modules_of(run.machine))
        rows.push_back({{"module", run.machine.processes[i].name}, {"cycles", process_sum(run, i).cycles}});
    return rows;
}

Json stall_row(Machine const& machine, std::size_t module, std::size_t fifo, Cycles cycles) {
    MachineFifo const& of = machine.fifos[fifo];
    bool const reads = of.reader == module;
    return {{"module", machine.processes[module].name},
            {"kind", name_of(reads ? CycleClass::empty_stall : CycleClass::full_stall)},
            {"item", of.name},
            {"waits_for", machine.processes[reads ? of.writer : of.reader].name},
            {"cycles", cycles}};
}

Json conflict_row(Machine const& machine, std::size_t module, std::size_t bram, Cycles cycles) {
    return {{"module", machine.processes[module].name},
            {"kind", name_of(CycleClass::port_conflict)},
            {"item", machine.memories[bram].name},
            {"waits_for", ""},
            {"cycles", cycles}};
}

/// What held the modules up: a row per module and FIFO or block RAM that cost it cycles.
Json stalls(RunStatistics const& run) {
    Json rows = Json::array();
    for (std::size_t const i : modules_of(run.machine)) {
        ProcessStatistics const process = process_sum(run, i);
        for (std::size_t f = 0; f < process.stalls.size(); ++f)
            if (process.stalls[f] > 0)
                rows.push_back(stall_row(run.machine, i, f, process.stalls[f]));
        for (std::size_t b = 0; b < process.port_conflicts.size(); ++b)
            if (process.port_conflicts[b] > 0)
                rows.push_back(conflict_row(run.machine, i, b, process.port_conflicts[b]));
    }
    return rows;
}

/// Nothing without samples.
Json latency(RunStatistics const& run) {
    std::vector<Cycles> const latencies = sorted_latencies(run);
    if (latencies.empty())
        return nullptr;
    LatencyHistogram const histogram = latency_histogram(latencies);
    return {{"min", latencies.front()},
            {"tenth", latency_at(latencies, 0.1)},
            {"median", latency_at(latencies, 0.5)},
            {"ninetieth", latency_at(latencies, 0.9)},
            {"max", latencies.back()},
            {"histogram", {{"first", histogram.first}, {"width", histogram.width}, {"counts", histogram.counts}}}};
}

char const* kind_name(TimelineSpan::Kind kind) {
    switch (kind) {
        case TimelineSpan::Kind::loop:
            return "loop";
        case TimelineSpan::Kind::empty_stall:
            return name_of(CycleClass::empty_stall);
        case TimelineSpan::Kind::full_stall:
            return name_of(CycleClass::full_stall);
        case TimelineSpan::Kind::memory_stall:
            return name_of(CycleClass::memory_stall);
    }
    return "";
}

std::string item_name(Machine const& machine, TimelineSpan const& span) {
    if (span.kind == TimelineSpan::Kind::memory_stall)
        return "memory";
    return span.kind == TimelineSpan::Kind::loop ? machine.loops[span.item].name : machine.fifos[span.item].name;
}

/// Short rows, because there are thousands: module, kind, item, begin, end, cycles, iterations of a loop, spans.
Json spans(Machine const& machine, SampleTimeline const& timeline) {
    constexpr Cycles distinguishable = 2000;  // positions along a wide screen
    Json rows = Json::array();
    for (MergedSpan const& span : merged_spans(timeline.spans, (timeline.end - timeline.begin) / distinguishable))
        rows.push_back({machine.processes[span.extent.module].name, kind_name(span.extent.kind),
                        item_name(machine, span.extent), span.extent.begin, span.extent.end, span.cycles,
                        span.extent.kind == TimelineSpan::Kind::loop ? span.extent.count : 0, span.spans});
    return rows;
}

Json occupancy(Machine const& machine, SampleTimeline const& timeline) {
    constexpr std::size_t parts = 120;
    Json fifo_profiles = Json::object();
    for (std::size_t f = 0; f < timeline.occupancy.size(); ++f) {
        Json means = Json::array(), maxima = Json::array();
        for (OccupancyPart const& part :
             occupancy_profile(timeline.occupancy[f], timeline.begin, timeline.end, parts)) {
            means.push_back(std::round(part.mean * 1000) / 1000);
            maxima.push_back(part.max);
        }
        if (!means.empty())
            fifo_profiles[machine.fifos[f].name] = {{"mean", means}, {"max", maxima}};
    }
    return fifo_profiles;
}

Json timelines(Machine const& machine, std::vector<SampleTimeline> const& samples) {
    Json rows = Json::array();
    for (SampleTimeline const& timeline : samples)
        rows.push_back({{"core", timeline.core},
                        {"sample", timeline.sample},
                        {"begin", timeline.begin},
                        {"end", timeline.end},
                        {"spans", spans(machine, timeline)},
                        {"occupancy", occupancy(machine, timeline)}});
    return rows;
}

Json pictures(std::vector<ReportPicture> const& files) {
    Json rows = Json::array();
    for (ReportPicture const& picture : files)
        rows.push_back({{"title", picture.title}, {"png", base64(picture.png)}});
    return rows;
}

/// Values as text: JavaScript's numbers would round the larger integers.
Json configuration(std::vector<ResolvedKey> const& keys) {
    Json rows = Json::array();
    for (ResolvedKey const& key : keys)
        rows.push_back({{"key", key.key}, {"value", plain_text(key.value)}, {"default", key.is_default}});
    return rows;
}

}  // namespace

std::string report_data(HtmlReportInput const& input) {
    Json data;
    data["format"] = "faster-report";
    data["version"] = 1;
    data["headline"] = headline(input);
    data["bound_by"] = diagnosis_sentences(input.run);
    data["cycle_classes"] = Json::array();
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        if (is_class_of(c, input.run.machine.external_memory.has_value()))
            data["cycle_classes"].push_back(cycle_class_names[c]);
    data["modules"] = modules(input.run);
    data["stalls"] = stalls(input.run);
    data["path_causes"] = Json::array();
    for (char const* cause : path_cause_names)
        if (input.run.machine.external_memory || cause != name_of(PathCause::memory))
            data["path_causes"].push_back(cause);
    data["critical_path"] = input.run.critical_path ? critical_path_json(input.run) : Json();
    data["sensitivities"] = sensitivities_json(input.run);
    data["alternatives"] = alternatives_json(input.run);
    data["fifos"] = json_table(fifo_columns, fifo_rows(input.run));
    data["loops"] = json_table(loop_columns, loop_rows(input.run));
    data["hazards"] = hazard_sums_json(input.run);
    data["latency"] = latency(input.run);
    data["external_memory"] = memory_traffic_json(input.run);
    data["timelines"] = timelines(input.run.machine, input.timelines);
    data["pictures"] = pictures(input.pictures);
    data["configuration"] = configuration(input.keys);
    // File names may hold any bytes.
    return io::text_of(data);
}

}  // namespace faster::report
