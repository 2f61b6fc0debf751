#include "modules/faster_simulation.hpp"

#include <utility>

namespace faster {

std::unique_ptr<DataflowAccelerator> make_accelerator(AcceleratorConfig const& config, Stimulus const& stimulus,
                                                      std::shared_ptr<Machine const> machine, Engine engine,
                                                      SampleProbe* probe) {
    auto const make_core = [&](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                               TimeBase const& time_base) {
        auto core = std::make_unique<RasterCore>(name, config, stimulus, of, share, time_base);
        core->set_probe(probe);
        return core;
    };
    return std::make_unique<DataflowAccelerator>("accelerator", std::move(machine), stimulus.samples.size(), engine,
                                                 make_core);
}

RunStatistics simulate(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                       SimulationOptions const& options, SampleProbe* probe) {
    auto machine = std::make_shared<Machine const>(make_machine(describe_raster_core(config), config));
    return simulate(*make_accelerator(config, stimulus, std::move(machine), engine, probe), options);
}

}  // namespace faster
