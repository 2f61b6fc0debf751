#pragma once
#include <memory>

#include "kernel/machine/machine.hpp"
#include "kernel/timing/core_timing.hpp"

namespace faster::replay {

/// A core with the processes and FIFOs of another, and the depths, latencies and intervals of a machine. Nothing has
/// happened in it yet.
std::unique_ptr<timing::CoreTiming> core_variant(timing::CoreTiming const& blueprint, Machine const& machine);

}  // namespace faster::replay
