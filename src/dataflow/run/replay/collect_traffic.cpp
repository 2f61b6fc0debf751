#include "dataflow/run/replay/collect_traffic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dataflow::replay {

namespace {

void set_latencies(timing::MasterFigures const& figures, MasterStatistics& row) {
    auto const reached_by = [&figures](double share) {
        return figures.latencies.reached_by(
            static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(figures.bursts))));
    };
    if (figures.bursts == 0)
        return;
    row.latency_least = figures.latencies.reached_by(1);
    row.latency_median = reached_by(0.5);
    row.latency_90 = reached_by(0.9);
    row.latency_most = figures.latencies.reached_by(figures.bursts);
}

}  // namespace

MemoryTraffic collect_traffic(timing::MemorySystem const& memory, Machine const& machine, std::size_t cores) {
    std::vector<std::size_t> const streams = streams_of(machine);
    timing::ExternalMemory const& shape = memory.shape();
    MemoryTraffic traffic;
    traffic.period_ps = shape.period_ps;
    traffic.port_bytes = shape.port_bytes;
    traffic.largest_queue = memory.controller().largest_queue;
    traffic.controller_busy_ps = static_cast<std::uint64_t>(std::min<Picoseconds>(
        Picoseconds{memory.controller().granules} * shape.granule_ps, std::numeric_limits<std::uint64_t>::max()));
    timing::ControllerHistory const& history = memory.controller().history;
    traffic.stretch_cycles = history.stretch_cycles();
    for (timing::ControllerHistory::Stretch const& stretch : history.stretches())
        traffic.stretches.push_back({stretch.beats * shape.port_bytes, stretch.largest_queue});
    traffic.port_beats = memory.port_beats();
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

}  // namespace dataflow::replay
