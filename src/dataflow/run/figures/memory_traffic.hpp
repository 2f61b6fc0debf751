#pragma once
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/column.hpp"
#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// What a master of a core moved, and how long that took: from asking for a burst to its last beat, or a write's
/// acknowledgement.
struct MasterStatistics {
    std::uint64_t core = 0;
    std::string master;
    std::uint64_t port = 0;
    std::uint64_t bursts = 0;
    std::uint64_t bytes = 0;  ///< whole beats
    Cycles latency_least = 0;
    Cycles latency_median = 0;
    Cycles latency_90 = 0;  ///< of nine in ten bursts at most
    Cycles latency_most = 0;
};

inline constexpr Column<MasterStatistics> master_columns[]{
    {"core", "-", &MasterStatistics::core, Tells::key, "its core"},
    {"master", "-", &MasterStatistics::master, Tells::key, "its name"},
    {"port", "-", &MasterStatistics::port, Tells::shape, "that it uses"},
    {"bursts", "-", &MasterStatistics::bursts, Tells::work, "asked for"},
    {"bytes", "bytes", &MasterStatistics::bytes, Tells::work, "moved, in whole beats"},
    {"latency_least", "cycles", &MasterStatistics::latency_least, Tells::peak,
     "from asking for a burst to its last beat, or a write's acknowledgement"},
    {"latency_median", "cycles", &MasterStatistics::latency_median, Tells::peak, "likewise"},
    {"latency_90", "cycles", &MasterStatistics::latency_90, Tells::peak, "likewise: of nine in ten at most"},
    {"latency_most", "cycles", &MasterStatistics::latency_most, Tells::peak, "likewise"},
};

/// A stretch of time at the controller.
struct TrafficStretch {
    std::uint64_t bytes = 0;          ///< of bursts that arrived in it, in whole beats
    std::uint64_t largest_queue = 0;  ///< that one of those found, itself included
};

/// The external memory of a run that has one.
struct MemoryTraffic {
    std::vector<MasterStatistics> masters;  ///< of the first core, of the second, ...
    std::vector<Cycles> port_beats;         ///< cycles in which a port brought data, by port
    std::uint64_t controller_busy_ps = 0;
    std::uint64_t largest_queue = 0;  ///< bursts that have arrived at the controller and not begun
    std::uint64_t period_ps = 1;      ///< of a cycle
    std::uint64_t port_bytes = 1;     ///< of a beat
    Cycles stretch_cycles = 1;
    std::vector<TrafficStretch> stretches;  ///< from cycle 0 on, so many cycles each
    std::optional<Cycles> compute_alone;    ///< cycles of the cores with an ideal memory, if that was worked out

    std::uint64_t bytes() const;
    std::uint64_t bytes_read(std::size_t port) const { return port_beats[port] * port_bytes; }
    /// In 1e9 bytes per second, over so many cycles.
    double gb_per_s(std::uint64_t bytes, Cycles cycles) const;
    double controller_utilisation(Cycles cycles) const;
    /// What the memory would take if the cores never kept it waiting.
    Cycles memory_alone() const;
};

}  // namespace dataflow
