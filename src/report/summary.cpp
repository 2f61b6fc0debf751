#include "report/summary.hpp"

#include <nlohmann/json.hpp>

#include "report/csv.hpp"
#include "report/diagnosis_text.hpp"

namespace faster::report {

namespace {

using Json = nlohmann::ordered_json;

Json configuration(std::vector<ResolvedKey> const& keys) {
    Json object = Json::object();
    for (ResolvedKey const& key : keys)
        object[key.key] = {{"value", Json::parse(json_text(key.value))}, {"default", key.is_default}};
    return object;
}

/// What is not zero, by name.
template <std::size_t N> Json by_name(std::array<Cycles, N> const& cycles, std::array<char const*, N> const& names) {
    Json object = Json::object();
    for (std::size_t i = 0; i < N; ++i)
        if (cycles[i] > 0)
            object[names[i]] = cycles[i];
    return object;
}

Json module_row(std::size_t core, std::size_t i, ProcessStatistics const& p) {
    Json row{{"core", core}, {"module", module_names[i]}};
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        row[std::string(cycle_class_names[c]) + "_cycles"] = p.cycles[c];
    row["stalls"] = by_name(p.stalls, fifo_names);
    row["port_conflicts"] = by_name(p.port_conflicts, bram_names);
    return row;
}

Json fifo_row(std::size_t core, std::size_t i, FifoStatistics const& f) {
    return {{"core", core},
            {"fifo", fifo_names[i]},
            {"kind", kind_name(f.kind)},
            {"depth", f.depth},
            {"capacity", f.capacity},
            {"write_latency", f.write_latency},
            {"writes", f.writes},
            {"reads", f.reads},
            {"full_stall_cycles", f.full_stall_cycles},
            {"empty_stall_cycles", f.empty_stall_cycles},
            {"max_occupancy", f.max_occupancy}};
}

Json loop_row(std::size_t core, std::size_t i, LoopStatistics const& l) {
    return {{"core", core},
            {"module", name_of(loop_names[i].module)},
            {"loop", loop_names[i].name},
            {"ii_target", l.ii_target},
            {"ii_recurrence", l.ii_recurrence},
            {"ii", l.ii},
            {"depth", l.depth},
            {"entries", l.entries},
            {"iterations", l.iterations},
            {"port_conflict_cycles", l.port_conflict_cycles},
            {"recurrence_cycles", l.recurrence_cycles},
            {"limited_by", l.limited_by}};
}

/// Data width of each map [bits]: thesis A.2 (u1) and A.3 with SPEC section 2 (u11).
int bits_of(BramId id) { return id == BramId::depth_buffer ? 11 : 1; }

Json bram_row(std::size_t core, std::size_t i, AcceleratorConfig const& config, CoreStatistics const& statistics) {
    auto const id = static_cast<BramId>(i);
    Cycles conflicts = 0;
    for (LoopStatistics const& loop : statistics.loops)
        if (loop.limited_by == name_of(id))
            conflicts += loop.port_conflict_cycles;
    auto const side = static_cast<std::uint64_t>(config.window);
    return {{"core", core},
            {"bram", name_of(id)},
            {"words", side * side},
            {"bits", bits_of(id)},
            {"ports", config.bram(id).ports},
            {"port_conflict_cycles", conflicts}};
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
        for (std::size_t i = 0; i < module_count; ++i)
            summary["modules"].push_back(module_row(core, i, statistics.processes[i]));
        for (std::size_t i = 0; i < fifo_count; ++i)
            summary["fifos"].push_back(fifo_row(core, i, statistics.fifos[i]));
        for (std::size_t i = 0; i < bram_count; ++i)
            summary["brams"].push_back(bram_row(core, i, config, statistics));
        for (std::size_t i = 0; i < loop_count; ++i)
            summary["loops"].push_back(loop_row(core, i, statistics.loops[i]));
    }
    summary["bound_by"] = diagnosis_sentences(config, run);
    summary["configuration"] = configuration(keys);
    summary["host"] = {{"build_seconds", host.build_seconds}, {"simulate_seconds", host.simulate_seconds}};
    return summary.dump(2) + "\n";
}

}  // namespace faster::report
