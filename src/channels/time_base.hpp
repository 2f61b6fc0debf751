#pragma once
#include <cstdint>

#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// How simulated time is driven: the engine, and the length of a cycle on the SystemC kernel's clock.
struct TimeBase {
    Engine engine = Engine::decoupled;
    double clock_mhz = 200.0;
    std::uint64_t ticks_per_cycle() const;  ///< in units of the kernel's time resolution, rounded, at least 1
};

}  // namespace dataflow
