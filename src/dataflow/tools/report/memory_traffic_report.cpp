#include "dataflow/tools/report/memory_traffic_report.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/tools/report/json_rows.hpp"

namespace dataflow::report {

namespace {

double percent(double share) { return 100 * share; }

double share_of(Cycles part, Cycles whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// The least latency of two cores' bursts; that of a core without any is 0, and says nothing.
Cycles least_of(MasterStatistics const& one, MasterStatistics const& other) {
    if (one.bursts == 0 || other.bursts == 0)
        return one.bursts == 0 ? other.latency_least : one.latency_least;
    return std::min(one.latency_least, other.latency_least);
}

/// A master of all cores together: latencies of the core with the largest.
std::vector<MasterStatistics> over_cores(MemoryTraffic const& traffic) {
    std::vector<MasterStatistics> sums;
    for (MasterStatistics const& row : traffic.masters) {
        auto const same = [&row](MasterStatistics const& sum) { return sum.master == row.master; };
        auto const found = std::find_if(sums.begin(), sums.end(), same);
        if (found == sums.end()) {
            sums.push_back(row);
            continue;
        }
        found->latency_least = least_of(*found, row);
        found->bursts += row.bursts;
        found->bytes += row.bytes;
        found->latency_median = std::max(found->latency_median, row.latency_median);
        found->latency_90 = std::max(found->latency_90, row.latency_90);
        found->latency_most = std::max(found->latency_most, row.latency_most);
    }
    return sums;
}

Cycles memory_stalls(RunStatistics const& run) {
    Cycles sum = 0;
    for (CoreStatistics const& core : run.cores)
        for (ProcessStatistics const& process : core.processes)
            sum += process[CycleClass::memory_stall];
    return sum;
}

/// What would be left if either cost nothing, beside what there is.
std::string roofline_text(MemoryTraffic const& traffic, Cycles cycles) {
    std::string const compute = traffic.compute_alone
                                    ? fmt::format("compute alone {} cycles", *traffic.compute_alone)
                                    : "compute alone is worked out with --report, --events or --sensitivities";
    return fmt::format("  roofline: {} cycles; memory alone {} cycles, {}\n", cycles, traffic.memory_alone(), compute);
}

Json stretches_json(MemoryTraffic const& traffic) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < traffic.stretches.size(); ++i)
        rows.push_back({{"begin_cycle", i * traffic.stretch_cycles},
                        {"bytes", traffic.stretches[i].bytes},
                        {"largest_queue", traffic.stretches[i].largest_queue}});
    return rows;
}

}  // namespace

std::string memory_traffic_text(RunStatistics const& run) {
    if (!run.memory)
        return {};
    MemoryTraffic const& traffic = *run.memory;
    Cycles const cycles = run.core_cycles();
    std::string text = fmt::format(
        "\nExternal memory: {} bytes, {:.2f} GB/s; controller busy {:.1f} %, largest queue {} bursts; memory stalls "
        "{} lane-cycles\n",
        grouped(traffic.bytes()), traffic.gb_per_s(traffic.bytes(), cycles),
        percent(traffic.controller_utilisation(cycles)), traffic.largest_queue, grouped(memory_stalls(run)));
    if (run.load_cycles > 0)
        text += fmt::format("  load: {} cycles before cycle 0, which the total has\n", grouped(run.load_cycles));
    text += roofline_text(traffic, cycles);
    for (std::size_t port = 0; port < traffic.port_beats.size(); ++port)
        text += fmt::format("  port {}: {} bytes read, {:.2f} GB/s, busy {:.1f} %\n", port,
                            grouped(traffic.bytes_read(port)), traffic.gb_per_s(traffic.bytes_read(port), cycles),
                            percent(share_of(traffic.port_beats[port], cycles)));
    text += fmt::format("  {:<12} {:>12} {:>16} {:>7} {:>46}\n", "master", "bursts", "bytes", "GB/s",
                        "latency of bursts [cycles]: least median 90 % most");
    for (MasterStatistics const& row : over_cores(traffic))
        text += fmt::format("  {:<12} {:>12} {:>16} {:>7.2f} {:>28} {:>6} {:>6} {:>7}\n", row.master,
                            grouped(row.bursts), grouped(row.bytes), traffic.gb_per_s(row.bytes, cycles),
                            row.latency_least, row.latency_median, row.latency_90, row.latency_most);
    return text;
}

Json memory_traffic_json(RunStatistics const& run) {
    if (!run.memory)
        return {};
    MemoryTraffic const& traffic = *run.memory;
    Json ports = Json::array();
    for (std::size_t port = 0; port < traffic.port_beats.size(); ++port)
        ports.push_back({{"port", port},
                         {"beats", traffic.port_beats[port]},
                         {"bytes_read", traffic.bytes_read(port)},
                         {"gb_per_s", traffic.gb_per_s(traffic.bytes_read(port), run.core_cycles())},
                         {"utilisation", share_of(traffic.port_beats[port], run.core_cycles())}});
    Json masters = json_table(master_columns, traffic.masters);
    for (std::size_t i = 0; i < traffic.masters.size(); ++i)
        masters[i]["gb_per_s"] = traffic.gb_per_s(traffic.masters[i].bytes, run.core_cycles());
    return {{"bytes", traffic.bytes()},
            {"gb_per_s", traffic.gb_per_s(traffic.bytes(), run.core_cycles())},
            {"memory_stall_cycles", memory_stalls(run)},
            {"memory_alone_cycles", traffic.memory_alone()},
            {"compute_alone_cycles", traffic.compute_alone ? Json(*traffic.compute_alone) : Json()},
            {"over_time", {{"cycles", traffic.stretch_cycles}, {"stretches", stretches_json(traffic)}}},
            {"controller",
             {{"busy_ps", traffic.controller_busy_ps},
              {"utilisation", traffic.controller_utilisation(run.core_cycles())},
              {"largest_queue", traffic.largest_queue}}},
            {"ports", ports},
            {"masters", masters}};
}

}  // namespace dataflow::report
