#pragma once
#include <cstdint>

#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// Whether data from outside the cores cost time: `ideal`, they are there when they are asked for; `axi`, they come in
/// bursts through ports and one controller, which all cores share.
enum class MemoryModel { ideal, axi };

/// What a configuration asks of the external memory; keys `accelerator.memory.*`.
struct ExternalMemorySettings {
    MemoryModel model = MemoryModel::ideal;
    std::uint64_t burst_bytes = 256;  ///< a power of two, at least port_bytes; ranges are cut at its multiples
    std::uint64_t port_bytes = 16;    ///< bytes of a beat, a power of two
    std::uint64_t outstanding = 16;   ///< bursts of a master that are asked for and not done, >= 1
    bool prefetch = false;            ///< masters work ahead of their processes
    std::uint64_t ports = 3;          ///< core c uses port c mod ports, >= 1
    Cycles request_cycles = 24;       ///< from asking to the controller
    double dram_gb_per_s = 19.2;      ///< peak of the controller, 1e9 bytes per second
    double dram_efficiency = 0.75;    ///< part of it that can be had, above 0, at most 1
    double read_latency_ns = 120.0;   ///< from a burst's begin to its first beat at the port
};

}  // namespace dataflow
