#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "kernel/base/cycles.hpp"

namespace faster::timing {

/// What happened at one master.
struct MasterFigures {
    std::uint64_t bursts = 0;
    std::uint64_t beats = 0;
    std::map<Cycles, std::uint64_t> latencies;  ///< bursts by the cycles from asking to their last beat
};

struct PortFigures {
    std::uint64_t beats = 0;  ///< that it brought to the cores
};

struct ControllerFigures {
    std::uint64_t granules = 0;
    std::uint64_t largest_queue = 0;  ///< bursts that have arrived and not begun
};

}  // namespace faster::timing
