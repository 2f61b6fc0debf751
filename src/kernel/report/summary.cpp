#include "kernel/report/summary.hpp"

#include <nlohmann/json.hpp>

#include "faster/block_ram.hpp"
#include "faster/parts.hpp"
#include "kernel/report/critical_path_report.hpp"
#include "kernel/report/diagnosis_text.hpp"
#include "kernel/report/json_rows.hpp"
#include "kernel/report/sensitivity_report.hpp"

namespace faster::report {

namespace {

Json configuration(std::vector<ResolvedKey> const& keys) {
    Json object = Json::object();
    for (ResolvedKey const& key : keys)
        object[key.key] = {{"value", Json::parse(json_text(key.value))}, {"default", key.is_default}};
    return object;
}

Json bram_row(std::size_t core, std::size_t i, AcceleratorConfig const& config, CoreStatistics const& statistics) {
    auto const id = static_cast<BramId>(i);
    MemoryShape const memory = memory_shape(id, config);
    return {{"core", core},
            {"bram", name_of(id)},
            {"words", memory.words},
            {"bits", memory.bits},
            {"banks", memory.partition},
            {"buffers", memory.buffers},
            {"ports", memory.ports},
            {"ramb36", ramb36_count(memory)},
            {"port_conflict_cycles", port_conflict_cycles(statistics, id)}};
}

Json line_buffer_row(std::size_t core, MemoryShape const& memory) {
    return {{"core", core},          {"bram", "line_buffers"},         {"words", memory.words},
            {"bits", memory.bits},   {"banks", memory.partition},      {"buffers", memory.buffers},
            {"ports", memory.ports}, {"ramb36", ramb36_count(memory)}, {"port_conflict_cycles", 0}};
}

}  // namespace

double milliseconds(Cycles cycles, AcceleratorConfig const& config) {
    return static_cast<double>(cycles) / (config.clock_mhz * 1e3);
}

std::string summary_json(std::vector<ResolvedKey> const& keys, AcceleratorConfig const& config,
                         RunStatistics const& run, HostTime const& host) {
    Json summary;
    summary["format"] = "faster-summary";
    summary["version"] = 1;
    summary["total_cycles"] = run.total_cycles;
    summary["milliseconds"] = milliseconds(run.total_cycles, config);
    summary["samples"] = run.samples.size();
    summary["raster_cores"] = run.cores.size();
    for (char const* table : {"modules", "fifos", "brams", "loops"})
        summary[table] = Json::array();
    for (std::size_t core = 0; core < run.cores.size(); ++core) {
        CoreStatistics const& statistics = run.cores[core];
        for (std::size_t const i : modules_of(run.parts))
            summary["modules"].push_back(module_row(core, i, statistics.processes[i]));
        for (std::size_t const i : fifos_of(run.parts))
            summary["fifos"].push_back(fifo_row(core, i, statistics.fifos[i]));
        for (std::size_t const i : brams_of(run.parts))
            summary["brams"].push_back(bram_row(core, i, config, statistics));
        if (MemoryShape const memory = line_buffer_shape(config); memory.words > 0)
            summary["brams"].push_back(line_buffer_row(core, memory));
        for (std::size_t const i : loops_of(run.parts))
            summary["loops"].push_back(loop_row(core, i, statistics.loops[i]));
    }
    summary["bound_by"] = diagnosis_sentences(config, run);
    if (run.critical_path)
        summary["critical_path"] = critical_path_json(run);
    if (!run.sensitivities.empty())
        summary["sensitivities"] = sensitivities_json(run);
    summary["configuration"] = configuration(keys);
    summary["host"] = {{"build_seconds", host.build_seconds}, {"simulate_seconds", host.simulate_seconds}};
    return summary.dump(2) + "\n";
}

std::string deadlock_summary_json(std::vector<ResolvedKey> const& keys, RunStatistics const& run) {
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
    Json summary;
    summary["format"] = "faster-summary";
    summary["version"] = 1;
    summary["deadlock"] = {
        {"cycle", run.deadlock_cycle()}, {"wait_cycle", rows(run.wait_cycle())}, {"stuck", rows(run.stuck)}};
    summary["configuration"] = configuration(keys);
    return summary.dump(2) + "\n";
}

}  // namespace faster::report
