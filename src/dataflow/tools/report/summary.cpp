#include "dataflow/tools/report/summary.hpp"

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "dataflow/tools/report/critical_path_report.hpp"
#include "dataflow/tools/report/diagnosis_text.hpp"
#include "dataflow/tools/report/hazard_report.hpp"
#include "dataflow/tools/report/json_rows.hpp"
#include "dataflow/tools/report/memory_traffic_report.hpp"
#include "dataflow/tools/report/power_report.hpp"
#include "dataflow/tools/report/resource_report.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"
#include "dataflow/tools/report/timing_report.hpp"

namespace dataflow::report {

namespace {

Json configuration_json(std::vector<ResolvedKey> const& keys) {
    Json object = Json::object();
    for (ResolvedKey const& key : keys)
        object[key.key] = {{"value", Json::parse(json_text(key.value))}, {"default", key.is_default}};
    return object;
}

/// Which module writes each FIFO of a core, and which reads it.
Json dataflow_json(Machine const& machine) {
    Json rows = Json::array();
    for (MachineFifo const& fifo : machine.fifos)
        if (fifo.is_present)
            rows.push_back({{"fifo", fifo.name},
                            {"from", machine.processes[fifo.writer].name},
                            {"to", machine.processes[fifo.reader].name}});
    return rows;
}

/// What was done until nothing could move.
Json partial_json(RunStatistics const& run) {
    return {{"samples", run.samples.size()},
            {"fifos", json_table(fifo_columns, fifo_rows(run))},
            {"loops", json_table(loop_columns, loop_rows(run))}};
}

}  // namespace

std::string summary_json(std::vector<ResolvedKey> const& keys, RunStatistics const& run, HostTime const& host,
                         Json const& made_by) {
    Json summary;
    summary["format"] = "faster-summary";
    summary["version"] = 1;
    summary["total_cycles"] = run.total_cycles;
    summary["milliseconds"] = run.machine.milliseconds(run.total_cycles);
    summary["samples"] = run.samples.size();
    summary["raster_cores"] = run.cores.size();
    summary["modules"] = Json::array();
    for (ModuleRow const& row : module_rows(run))
        summary["modules"].push_back(json_row(row));
    summary["fifos"] = json_table(fifo_columns, fifo_rows(run));
    summary["brams"] = json_table(memory_columns, memory_rows(run));
    summary["loops"] = json_table(loop_columns, loop_rows(run));
    summary["dataflow"] = dataflow_json(run.machine);
    if (Json hazards = hazards_json(run); !hazards.empty())
        summary["hazards"] = std::move(hazards);
    if (run.memory)
        summary["load_cycles"] = run.load_cycles;
    if (run.memory)
        summary["external_memory"] = memory_traffic_json(run);
    summary["bound_by"] = diagnosis_sentences(run);
    if (run.critical_path)
        summary["critical_path"] = critical_path_json(run);
    if (!run.sensitivities.empty())
        summary["sensitivities"] = sensitivities_json(run);
    if (!run.alternatives.empty())
        summary["alternatives"] = alternatives_json(run);
    if (!run.warnings.empty())
        summary["warnings"] = run.warnings;
    summary["configuration"] = configuration_json(keys);
    summary["resources"] = resources_json(run.machine);
    if (Json timing = timing_json(run.machine); !timing.is_null())
        summary["timing"] = std::move(timing);
    if (Json power = power_json(run); !power.is_null())
        summary["power"] = std::move(power);
    summary["host"] = {{"build_seconds", host.build_seconds}, {"simulate_seconds", host.simulate_seconds}};
    if (!made_by.is_null())
        summary["made_by"] = made_by;
    return io::text_of(summary, 2) + "\n";
}

Json deadlock_json(RunStatistics const& run) {
    auto const rows = [](std::vector<StuckProcess> const& processes) {
        Json array = Json::array();
        for (StuckProcess const& p : processes)
            array.push_back({{"core", p.core},
                             {"process", p.process},
                             {"position", p.position},
                             {"source", p.source},
                             {"waits_for", p.waits_for},
                             {"to", p.to_write ? "write" : "read"},
                             {"fifo", p.fifo},
                             {"occupancy", p.occupancy},
                             {"capacity", p.capacity},
                             {"since_cycle", p.since_cycle}});
        return array;
    };
    return {{"cycle", run.deadlock_cycle()}, {"wait_cycle", rows(run.wait_cycle())}, {"stuck", rows(run.stuck)}};
}

std::string deadlock_summary_json(std::vector<ResolvedKey> const& keys, RunStatistics const& run, Json const& made_by) {
    Json summary;
    summary["format"] = "faster-summary";
    summary["version"] = 1;
    summary["deadlock"] = deadlock_json(run);
    summary["partial"] = partial_json(run);
    summary["configuration"] = configuration_json(keys);
    if (!made_by.is_null())
        summary["made_by"] = made_by;
    return io::text_of(summary, 2) + "\n";
}

}  // namespace dataflow::report
