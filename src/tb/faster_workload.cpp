#include "tb/faster_workload.hpp"

#include "faster/config/faster_config.hpp"
#include "faster/workload/pose_list.hpp"
#include "faster/workload/workload_source.hpp"
#include "modules/core/faster_simulation.hpp"

namespace faster {

/// A trace knows no poses.
std::string FasterWorkload::table() const {
    return stimulus.is_posed() ? workload::pose_list_csv(stimulus.posed.poses) : std::string{};
}

std::unique_ptr<Workload> FasterSimulation::load_workload(LoadedConfig& loaded) const {
    auto workload = std::make_unique<FasterWorkload>();
    workload->stimulus = load_stimulus(loaded);
    workload->notes = stimulus_warnings(workload->stimulus, loaded);
    return workload;
}

std::unique_ptr<DataflowAccelerator> FasterSimulation::elaborate(RunConfig const& config,
                                                                 std::shared_ptr<Machine const> machine,
                                                                 Workload& workload) const {
    auto const& ours = static_cast<FasterWorkload const&>(workload);
    return make_accelerator(accelerator_of(config), ours.stimulus, std::move(machine), config.simulation.engine,
                            ours.probe);
}

}  // namespace faster

dataflow::SimulatedDesign const& dataflow::simulated_design() {
    static faster::FasterSimulation const design;
    return design;
}
