#include "kernel/replay/collect_traffic.hpp"

#include <cmath>
#include <iterator>

namespace faster::replay {

namespace {

using Latencies = std::map<Cycles, std::uint64_t>;

/// The smallest that a share of the bursts does not exceed.
Cycles latency_at(Latencies const& latencies, std::uint64_t bursts, double share) {
    auto const wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(bursts)));
    std::uint64_t seen = 0;
    for (auto const& [latency, count] : latencies) {
        seen += count;
        if (seen >= wanted)
            return latency;
    }
    return 0;
}

void set_latencies(timing::MasterFigures const& figures, MasterStatistics& row) {
    if (figures.latencies.empty())
        return;
    row.latency_least = figures.latencies.begin()->first;
    row.latency_median = latency_at(figures.latencies, figures.bursts, 0.5);
    row.latency_90 = latency_at(figures.latencies, figures.bursts, 0.9);
    row.latency_most = std::prev(figures.latencies.end())->first;
}

}  // namespace

MemoryTraffic collect_traffic(timing::MemorySystem const& memory, Machine const& machine, std::size_t cores) {
    std::vector<std::size_t> const streams = streams_of(machine);
    timing::ExternalMemory const& shape = memory.shape();
    MemoryTraffic traffic;
    traffic.period_ps = shape.period_ps;
    traffic.port_bytes = shape.port_bytes;
    traffic.largest_queue = memory.controller().largest_queue;
    traffic.controller_busy_ps = memory.controller().granules * shape.granule_ps;
    timing::ControllerHistory const& history = memory.controller().history;
    traffic.stretch_cycles = history.stretch_cycles();
    for (timing::ControllerHistory::Stretch const& stretch : history.stretches())
        traffic.stretches.push_back({stretch.granules * timing::ExternalMemory::granule_bytes, stretch.largest_queue});
    for (timing::PortFigures const& port : memory.ports())
        traffic.port_beats.push_back(port.beats);
    for (std::size_t core = 0; core < cores; ++core)
        for (std::size_t master = 0; master < streams.size(); ++master) {
            timing::MasterFigures const& figures = memory.figures(core, master);
            MasterStatistics row;
            row.core = core;
            row.master = machine.streams[streams[master]].name;
            row.port = core % shape.ports;
            row.bursts = figures.bursts;
            row.bytes = figures.beats * shape.port_bytes;
            set_latencies(figures, row);
            traffic.masters.push_back(std::move(row));
        }
    return traffic;
}

}  // namespace faster::replay
