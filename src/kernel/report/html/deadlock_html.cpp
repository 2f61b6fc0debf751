#include "kernel/report/html/deadlock_html.hpp"

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/config/configuration_hash.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/report/html/fill_page.hpp"
#include "kernel/report/html/graph_data.hpp"
#include "kernel/report/html/page.hpp"
#include "kernel/report/html/run_data.hpp"
#include "kernel/report/provenance.hpp"
#include "kernel/report/summary.hpp"

namespace faster::report {

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

}  // namespace

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
                          std::vector<ResolvedKey> const& keys) {
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
    data["fifos"] = fifos(run);
    data["configuration"] = configuration_data(keys);
    return filled_page(deadlock_page, title, made_by_html(configuration_hash(keys)), io::text_of(data));
}

}  // namespace faster::report
