#include "tool/simulated_run.hpp"

#include "kernel/config/design.hpp"

namespace faster {

RunStatistics simulate(RunConfig const& config, Workload& workload, SimulationOptions const& options) {
    Machine const machine = machine_of(config);
    auto const accelerator = simulated_design().elaborate(config, machine, workload);
    return simulate(*accelerator, machine, config.simulation.engine, options);
}

RunStatistics simulate(LoadedConfig& loaded, SimulationOptions const& options) {
    auto const workload = simulated_design().load_workload(loaded);
    return simulate(loaded.config, *workload, options);
}

}  // namespace faster
