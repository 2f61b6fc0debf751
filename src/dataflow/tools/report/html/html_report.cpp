#include "dataflow/tools/report/html/html_report.hpp"

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "dataflow/tools/report/critical_path_report.hpp"
#include "dataflow/tools/report/diagnosis_text.hpp"
#include "dataflow/tools/report/hazard_report.hpp"
#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/html/graph_data.hpp"
#include "dataflow/tools/report/html/html_text.hpp"
#include "dataflow/tools/report/html/page.hpp"
#include "dataflow/tools/report/html/run_data.hpp"
#include "dataflow/tools/report/json_rows.hpp"
#include "dataflow/tools/report/latencies.hpp"
#include "dataflow/tools/report/memory_traffic_report.hpp"
#include "dataflow/tools/report/power_report.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "dataflow/tools/report/resource_report.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/report/timing_report.hpp"

namespace dataflow::report {

namespace {

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

Json pictures(std::vector<ReportPicture> const& files) {
    Json rows = Json::array();
    for (ReportPicture const& picture : files)
        rows.push_back({{"title", picture.title}, {"png", base64(picture.png)}});
    return rows;
}

/// Which samples stand for others is said with them.
Json timelines(HtmlReportInput const& input) {
    Json rows = Json::array();
    for (PackedTimeline const& timeline : input.timelines) {
        std::vector<std::string> is;
        for (StandoutSample const& standout : standout_samples(input.run))
            if (standout.sample->sample == timeline.sample)
                is.emplace_back(standout.is);
        rows.push_back(packed_timeline_json(timeline, is));
    }
    return rows;
}

/// The block RAMs of a core, with the port conflicts of all cores, and what the device has.
Json memory_area(RunStatistics const& run) {
    return {{"memories", json_table(memory_columns, over_cores(memory_columns, memory_rows(run)))},
            {"ramb36_of_device", ramb36_of_device}};
}

/// All figures, names and pictures of the HTML report as one JSON object on one line; docs/formats.md describes it.
std::string report_data(HtmlReportInput const& input) {
    Json data;
    data["format"] = "faster-report";
    data["version"] = 1;
    data["headline"] = headline_data(input.run);
    data["bound_by"] = diagnosis_sentences(input.run);
    data["warnings"] = input.run.warnings;
    data["graph"] = graph_data(input.run.machine);
    data["cycle_classes"] = cycle_class_data(input.run.machine);
    data["modules"] = module_data(input.run, input.run.machine);
    data["stalls"] = stall_data(input.run);
    data["path_causes"] = path_cause_data(input.run.machine);
    data["critical_path"] = input.run.critical_path ? critical_path_json(input.run) : Json();
    data["sensitivities"] = sensitivities_json(input.run);
    data["alternatives"] = alternatives_json(input.run);
    data["fifos"] = json_table(fifo_columns, fifo_rows(input.run));
    data["loops"] = json_table(loop_columns, loop_rows(input.run));
    data["resources"] = resources_json(input.run.machine);
    data["timing"] = timing_json(input.run.machine);
    data["power"] = power_json(input.run);
    data["hazards"] = hazard_sums_json(input.run);
    data["latency"] = latency(input.run);
    data["external_memory"] = memory_traffic_json(input.run);
    data["area"] = memory_area(input.run);
    data["timelines"] = timelines(input);
    data["pictures"] = pictures(input.pictures);
    data["configuration"] = configuration_data(input.keys);
    // File names may hold any bytes.
    return io::text_of(data);
}

}  // namespace

std::string html_report(HtmlReportInput const& input) {
    return filled_page(report_page, input.title, made_by_html(configuration_hash(input.keys)), report_data(input));
}

}  // namespace dataflow::report
