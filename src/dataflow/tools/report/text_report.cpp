#include "dataflow/tools/report/text_report.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/run/figures/column_values.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "dataflow/tools/report/critical_path_report.hpp"
#include "dataflow/tools/report/diagnosis_text.hpp"
#include "dataflow/tools/report/hazard_report.hpp"
#include "dataflow/tools/report/latencies.hpp"
#include "dataflow/tools/report/memory_traffic_report.hpp"
#include "dataflow/tools/report/power_report.hpp"
#include "dataflow/tools/report/resource_report.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"
#include "dataflow/tools/report/timing_report.hpp"

namespace dataflow::report {

namespace {

double percent(Cycles part, Cycles whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// A name as a column's title.
std::string in_words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}
std::size_t column_width(std::string_view name) { return std::max<std::size_t>(name.size(), 6); }

void headline(std::string& text, RunStatistics const& run) {
    Machine const& machine = run.machine;
    put_line(text, "{} samples on {} {}{}{}, {:g} MHz", run.samples.size(), run.cores.size(), machine.cores_are,
             machine.remark.empty() ? "" : ", ", machine.remark, machine.clock_mhz);
    put_line(text, "total  {} cycles = {:.3f} ms", grouped(run.total_cycles), machine.milliseconds(run.total_cycles));
    if (run.load_cycles > 0)
        put_line(text, "load   {} cycles of them, before cycle 0 of all that follows", grouped(run.load_cycles));
}

void module_table(std::string& text, RunStatistics const& run) {
    Cycles const lane_cycles = run.core_cycles() * run.cores.size();
    put_line(text, "\nModules: where the {} lane-cycles went [% of them; each row adds up to 100]",
             grouped(lane_cycles));
    std::string header = fmt::format("  {:<19}", "module");
    bool const has_memory = run.machine.external_memory.has_value();
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        if (is_class_of(c, has_memory))
            header += fmt::format(" {:>{}}", in_words(cycle_class_names[c]), column_width(cycle_class_names[c]));
    put_line(text, "{}", header);
    for (std::size_t const i : modules_of(run.machine)) {
        ProcessStatistics const p = process_sum(run, i);
        std::string row = fmt::format("  {:<19}", run.machine.processes[i].name);
        for (std::size_t c = 0; c < cycle_class_count; ++c)
            if (is_class_of(c, has_memory))
                row += fmt::format(" {:>{}.2f}", percent(p.cycles[c], lane_cycles), column_width(cycle_class_names[c]));
        put_line(text, "{}", row);
    }
}

std::string mean_trip_count(std::uint64_t iterations, std::uint64_t entries) {
    if (entries == 0)
        return "-";
    std::uint64_t const tenths = (10 * iterations + entries / 2) / entries;
    return fmt::format("{}.{}", grouped(tenths / 10), tenths % 10);
}

void loop_table(std::string& text, RunStatistics const& run) {
    put_line(text, "\nLoops: initiation interval (II) and pipeline depth [cycles]; trip count is the mean per entry");
    put_line(text, "  {:<25} {:>9} {:>11} {:<13} {:>6} {:>12} {:>14} {:>11} {:>21}", "loop", "II target", "II achieved",
             "limited by", "depth", "entries", "iterations", "trip count", "port conflict cycles");
    for (LoopRow const& l : over_cores(loop_columns, loop_rows(run)))
        put_line(text, "  {:<25} {:>9} {:>11} {:<13} {:>6} {:>12} {:>14} {:>11} {:>21}", l.name(), l.ii_target, l.ii,
                 l.limited_by.empty() ? "-" : l.limited_by, l.depth, grouped(l.entries), grouped(l.iterations),
                 mean_trip_count(l.iterations, l.entries), grouped(l.port_conflict_cycles));
}

void fifo_table(std::string& text, RunStatistics const& run) {
    put_line(text, "\nFIFOs: depth, and the largest occupancy of any core, in tokens; stalls in lane-cycles");
    put_line(text, "  {:<19} {:<14} {:>6} {:>14} {:>14} {:>14} {:>14}", "FIFO", "kind", "depth", "max occupancy",
             "tokens", "full stall", "empty stall");
    for (FifoRow const& f : over_cores(fifo_columns, fifo_rows(run)))
        put_line(text, "  {:<19} {:<14} {:>6} {:>14} {:>14} {:>14} {:>14}", f.fifo, f.kind_name, f.depth,
                 f.max_occupancy, grouped(f.writes), grouped(f.full_stall_cycles), grouped(f.empty_stall_cycles));
}

void bram_table(std::string& text, RunStatistics const& run) {
    if (brams_of(run.machine).empty() && run.machine.line_buffers.empty())
        return;
    auto const cores = static_cast<double>(run.cores.size());
    put_line(text,
             "\nBlock RAMs: {:g} RAMB36 in all without FIFOs, of the ZCU102's {:g}; port conflicts in lane-cycles",
             ramb36_of_core(run.machine) * cores, ramb36_of_device);
    put_line(text, "  {:<19} {:>9} {:>5} {:>6} {:>8} {:>6} {:>9} {:>14}", "memory", "words", "bits", "banks", "buffers",
             "ports", "RAMB36", "port conflict");
    for (MemoryRow const& m : over_cores(memory_columns, memory_rows(run)))
        put_line(text, "  {:<19} {:>9} {:>5} {:>6} {:>8} {:>6} {:>9g} {:>14}", m.bram, grouped(m.words), m.bits,
                 m.partition, m.buffers, m.ports, m.ramb36() * cores, grouped(m.port_conflict_cycles));
}

void latency_table(std::string& text, RunStatistics const& run) {
    std::vector<Cycles> const latencies = sorted_latencies(run);
    if (latencies.empty())
        return;
    auto const at = [&latencies](double share) { return grouped(latency_at(latencies, share)); };
    put_line(text, "\nSample latency, queueing included [cycles]");
    put_line(text, "  {:>12} {:>12} {:>12} {:>12} {:>12}", "min", "10 %", "median", "90 %", "max");
    put_line(text, "  {:>12} {:>12} {:>12} {:>12} {:>12}   (median {:.3f} ms)", at(0), at(0.1), at(0.5), at(0.9), at(1),
             run.machine.milliseconds(latency_at(latencies, 0.5)));
}

void host_speed(std::string& text, RunStatistics const& run, HostTime const& host) {
    double const lane_cycles = static_cast<double>(run.total_cycles * run.cores.size());
    put_line(text, "\nHost: workload {:.2f} s, simulation {:.2f} s, {:.1f} million lane-cycles/s", host.build_seconds,
             host.simulate_seconds, host.simulate_seconds > 0 ? lane_cycles / host.simulate_seconds / 1e6 : 0.0);
}

std::string describe(StuckProcess const& p) {
    std::string const place = p.source.empty() ? p.position : p.position + ", " + p.source;
    if (p.waits_for_memory)
        return fmt::format("core {}: {} ({}) waits for memory, {}; since cycle {}", p.core, p.process, place, p.fifo,
                           p.since_cycle);
    return fmt::format("core {}: {} ({}) waits for {} to {} {}, which holds {} of {} tokens; since cycle {}", p.core,
                       p.process, place, p.waits_for, p.to_write ? "read from" : "write to", p.fifo, p.occupancy,
                       p.capacity, p.since_cycle);
}

}  // namespace

std::string text_report(RunStatistics const& run, HostTime const& host) {
    std::string text;
    headline(text, run);
    text += '\n';
    for (std::string const& sentence : diagnosis_sentences(run))
        put_line(text, "  {}", sentence);
    text += critical_path_text(run);
    text += sensitivities_text(run);
    module_table(text, run);
    loop_table(text, run);
    fifo_table(text, run);
    bram_table(text, run);
    text += resources_text(run.machine);
    text += timing_text(run.machine);
    text += power_text(run);
    text += hazards_text(run);
    text += memory_traffic_text(run);
    latency_table(text, run);
    host_speed(text, run, host);
    return text;
}

std::string deadlock_report(RunStatistics const& run) {
    std::string text;
    put_line(text, "deadlock at cycle {}: nothing can move", run.deadlock_cycle());
    std::vector<StuckProcess> const circle = run.wait_cycle();
    if (!circle.empty())
        put_line(text, "wait-for cycle:");
    for (StuckProcess const& process : circle)
        put_line(text, "  {}", describe(process));
    std::uint64_t const first_core = run.stuck.front().core;
    put_line(text, "all stuck processes of core {}:", first_core);
    std::uint64_t last_core = first_core;
    std::size_t stuck_cores = 1;
    for (StuckProcess const& process : run.stuck) {
        if (process.core == first_core)
            put_line(text, "  {}", describe(process));
        stuck_cores += process.core != last_core ? 1U : 0U;
        last_core = process.core;
    }
    if (stuck_cores > 1)
        put_line(text, "{} of {} cores are stuck", stuck_cores, run.cores.size());
    return text;
}

}  // namespace dataflow::report
