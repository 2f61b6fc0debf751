#include "dataflow/tools/report/html/run_data.hpp"

#include "dataflow/base/enumerators.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/tools/report/critical_path_report.hpp"

namespace dataflow::report {

namespace {

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

}  // namespace

Json configuration_data(std::vector<ResolvedKey> const& keys) {
    Json rows = Json::array();
    for (ResolvedKey const& key : keys)
        rows.push_back({{"key", key.key}, {"value", plain_text(key.value)}, {"default", key.is_default}});
    return rows;
}

Json headline_data(RunStatistics const& run) {
    return {{"total_cycles", run.total_cycles},   {"milliseconds", run.machine.milliseconds(run.total_cycles)},
            {"samples", run.samples.size()},      {"cores", run.cores.size()},
            {"cores_are", run.machine.cores_are}, {"remark", run.machine.remark},
            {"load_cycles", run.load_cycles},     {"clock_mhz", run.machine.clock_mhz}};
}

/// In the order of cycle_class_data().
static Json cycles_by_class(RunStatistics const& run, std::size_t module, Machine const& classes) {
    ProcessStatistics const process = process_sum(run, module);
    Json cycles = Json::array();
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        if (is_class_of(c, classes.external_memory.has_value()))
            cycles.push_back(process.cycles[c]);
    return cycles;
}

Json module_data(RunStatistics const& run, Machine const& classes) {
    Json rows = Json::array();
    for (std::size_t const i : modules_of(run.machine))
        rows.push_back({{"module", run.machine.processes[i].name}, {"cycles", cycles_by_class(run, i, classes)}});
    return rows;
}

Json stall_data(RunStatistics const& run) {
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

Json cycle_class_data(Machine const& machine) {
    Json names = Json::array();
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        if (is_class_of(c, machine.external_memory.has_value()))
            names.push_back(cycle_class_names[c]);
    return names;
}

Json path_cause_data(Machine const& machine) {
    Json names = Json::array();
    for (std::string_view const cause : enumerator_names<PathCause>)
        if (machine.external_memory || cause != enumerator_name(PathCause::memory))
            names.push_back(cause);
    return names;
}

}  // namespace dataflow::report
