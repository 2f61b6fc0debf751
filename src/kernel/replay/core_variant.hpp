#pragma once
#include <memory>

#include "faster/accelerator_config.hpp"
#include "kernel/timing/core_timing.hpp"

namespace faster::retiming {

/// A core with the processes and FIFOs of another, and the depths, latencies and intervals of a configuration. Nothing
/// has happened in it yet.
std::unique_ptr<timing::CoreTiming> core_variant(timing::CoreTiming const& blueprint, AcceleratorConfig const& config);

}  // namespace faster::retiming
