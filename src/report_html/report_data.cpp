#include "report_html/report_data.hpp"

#include <cmath>

#include "config/parts.hpp"
#include "config/plain_value.hpp"
#include "report/critical_path_report.hpp"
#include "report/diagnosis_text.hpp"
#include "report/json_rows.hpp"
#include "report/latencies.hpp"
#include "report/sensitivity_report.hpp"
#include "report/summary.hpp"
#include "report_html/html_text.hpp"
#include "report_html/latency_histogram.hpp"
#include "report_html/timeline_view.hpp"
#include "stats/table_rows.hpp"

namespace faster::report {

namespace {

Json headline(HtmlReportInput const& input) {
    return {
        {"total_cycles", input.run.total_cycles}, {"milliseconds", milliseconds(input.run.total_cycles, input.config)},
        {"samples", input.run.samples.size()},    {"raster_cores", input.run.cores.size()},
        {"window", input.config.window},          {"clock_mhz", input.config.clock_mhz}};
}

Json modules(RunStatistics const& run) {
    Json rows = Json::array();
    for (std::size_t const i : modules_of(run.parts))
        rows.push_back({{"module", module_names[i]}, {"cycles", process_sum(run, i).cycles}});
    return rows;
}

Json stall_row(Parts const& parts, std::size_t module, std::size_t fifo, Cycles cycles) {
    FifoEnds const ends = ends_of(parts, FifoId{fifo});
    bool const reads = index_of(ends.reader) == module;
    return {{"module", module_names[module]},
            {"kind", name_of(reads ? CycleClass::empty_stall : CycleClass::full_stall)},
            {"item", fifo_names[fifo]},
            {"waits_for", name_of(reads ? ends.writer : ends.reader)},
            {"cycles", cycles}};
}

Json conflict_row(std::size_t module, std::size_t bram, Cycles cycles) {
    return {{"module", module_names[module]},
            {"kind", name_of(CycleClass::port_conflict)},
            {"item", bram_names[bram]},
            {"waits_for", ""},
            {"cycles", cycles}};
}

/// What held the modules up: a row per module and FIFO or block RAM that cost it cycles.
Json stalls(RunStatistics const& run) {
    Json rows = Json::array();
    for (std::size_t const i : modules_of(run.parts)) {
        ProcessStatistics const process = process_sum(run, i);
        for (std::size_t f = 0; f < fifo_count; ++f)
            if (process.stalls[f] > 0)
                rows.push_back(stall_row(run.parts, i, f, process.stalls[f]));
        for (std::size_t b = 0; b < bram_count; ++b)
            if (process.port_conflicts[b] > 0)
                rows.push_back(conflict_row(i, b, process.port_conflicts[b]));
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
    }
    return "";
}

char const* item_name(TimelineSpan const& span) {
    return span.kind == TimelineSpan::Kind::loop ? loop_names[span.item].name : fifo_names[span.item];
}

/// Short rows, because there are thousands: module, kind, item, begin, end, cycles, iterations of a loop, spans.
Json spans(SampleTimeline const& timeline) {
    constexpr Cycles distinguishable = 2000;  // positions along a wide screen
    Json rows = Json::array();
    for (MergedSpan const& span : merged_spans(timeline.spans, (timeline.end - timeline.begin) / distinguishable))
        rows.push_back({module_names[span.extent.module], kind_name(span.extent.kind), item_name(span.extent),
                        span.extent.begin, span.extent.end, span.cycles,
                        span.extent.kind == TimelineSpan::Kind::loop ? span.extent.count : 0, span.spans});
    return rows;
}

Json occupancy(SampleTimeline const& timeline) {
    constexpr std::size_t parts = 120;
    Json fifo_profiles = Json::object();
    for (std::size_t f = 0; f < fifo_count; ++f) {
        Json means = Json::array(), maxima = Json::array();
        for (OccupancyPart const& part :
             occupancy_profile(timeline.occupancy[f], timeline.begin, timeline.end, parts)) {
            means.push_back(std::round(part.mean * 1000) / 1000);
            maxima.push_back(part.max);
        }
        if (!means.empty())
            fifo_profiles[fifo_names[f]] = {{"mean", means}, {"max", maxima}};
    }
    return fifo_profiles;
}

Json timelines(std::vector<SampleTimeline> const& samples) {
    Json rows = Json::array();
    for (SampleTimeline const& timeline : samples)
        rows.push_back({{"core", timeline.core},
                        {"sample", timeline.sample},
                        {"begin", timeline.begin},
                        {"end", timeline.end},
                        {"spans", spans(timeline)},
                        {"occupancy", occupancy(timeline)}});
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
    data["bound_by"] = diagnosis_sentences(input.config, input.run);
    data["cycle_classes"] = cycle_class_names;
    data["modules"] = modules(input.run);
    data["stalls"] = stalls(input.run);
    data["path_causes"] = path_cause_names;
    data["critical_path"] = input.run.critical_path ? critical_path_json(input.run) : Json();
    data["sensitivities"] = sensitivities_json(input.run);
    data["fifos"] = json_table(fifo_columns, fifo_rows(input.run));
    data["loops"] = json_table(loop_columns, loop_rows(input.run));
    data["latency"] = latency(input.run);
    data["timelines"] = timelines(input.timelines);
    data["pictures"] = pictures(input.pictures);
    data["configuration"] = configuration(input.keys);
    // File names may hold any bytes.
    return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace faster::report
