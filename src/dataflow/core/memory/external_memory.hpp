#pragma once
#include <cstdint>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// An external memory: masters, which are processes' ends of it, ask for bursts; ports bring them to the cores; one
/// controller serves them all. What times mean is in docs/memory-model.md.
struct ExternalMemory {
    static constexpr std::uint64_t granule_bytes = 64;

    std::uint64_t burst_bytes = 256;  ///< ranges are cut at its multiples; a power of two
    std::uint64_t port_bytes = 16;    ///< of a beat; a power of two
    std::uint64_t outstanding = 16;   ///< bursts of a master that are asked for and not done
    bool prefetches = false;          ///< masters work ahead of their processes, where they can
    std::uint64_t ports = 3;          ///< core c uses port c mod ports
    Cycles request_cycles = 24;       ///< from asking to the controller
    std::uint64_t period_ps = 5000;   ///< of a cycle
    std::uint64_t latency_ps = 0;     ///< from a burst's begin to its first beat
    std::uint64_t granule_ps = 0;     ///< that the controller takes for a granule
    /// False: every master has a controller and a port to itself. No memory does that; no burst comes later there.
    bool is_shared = true;
};

/// What a master may ask for ahead of its process, if masters prefetch.
enum class Prefetch {
    none,    ///< nothing
    all,     ///< all of it, from the start on
    handed,  ///< what belongs to a sample, from the cycle on after its header was handed out
};

}  // namespace dataflow::timing
