#pragma once
#include <memory>

#include "chance/chance_design.hpp"
#include "channels/simple_simulation.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::chance {

/// A design by chance with its settings, ready to be run once.
struct Elaborated {
    Elaborated(SimulatedDesign const& simulation, Design const& design, Engine engine) {
        loaded.config.simulation.engine = engine;
        loaded.config.machine() = settings_of(design);
        loaded.config.as<SimpleConfig>().numbers.of("workload.samples") = design.samples;
        workload = simulation.load_workload(loaded);
        machine = std::make_shared<Machine const>(machine_of(loaded.config));
        accelerator = simulation.elaborate(loaded.config, machine, *workload);
    }

    LoadedConfig loaded;
    std::unique_ptr<Workload> workload;
    std::shared_ptr<Machine const> machine;
    std::unique_ptr<DataflowAccelerator> accelerator;
};

}  // namespace faster::chance
