#pragma once
#include "faster/accelerator_config.hpp"
#include "faster/workload_config.hpp"

namespace faster {

/// `lockstep` brings the SystemC kernel to local time before every operation; `decoupled` lets processes run ahead.
enum class Engine { lockstep, decoupled };

/// Keys `simulation.*`.
struct SimulationConfig {
    Engine engine = Engine::decoupled;
};

/// A whole configuration file, resolved.
struct RunConfig {
    AcceleratorConfig accelerator;
    WorkloadConfig workload;
    SimulationConfig simulation;
};

}  // namespace faster
