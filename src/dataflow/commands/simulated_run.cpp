#include "dataflow/commands/simulated_run.hpp"

#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"

namespace dataflow {

RunStatistics simulate(RunConfig const& config, Workload& workload, SimulationOptions const& options) {
    auto const machine = std::make_shared<Machine const>(machine_of(config));
    if (!options.at_any_size)
        require_memory(size_of_run(config, *machine, workload));
    return simulate(*simulated_design().elaborate(config, machine, workload), options);
}

RunStatistics simulate(LoadedConfig& loaded, SimulationOptions const& options) {
    auto const workload = simulated_design().load_workload(loaded);
    say_warnings(workload->warnings());
    return simulate(loaded.config, *workload, options);
}

}  // namespace dataflow
