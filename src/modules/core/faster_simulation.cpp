#include "modules/core/faster_simulation.hpp"

#include <utility>

#include "modules/core/memory_entries.hpp"

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
    bool const has_memory = machine->external_memory.has_value();
    if (has_memory)
        check_fits_on_chip(config.memory_placement, stimulus);
    auto accelerator = std::make_unique<DataflowAccelerator>("accelerator", std::move(machine), stimulus.samples.size(),
                                                             engine, make_core);
    if (has_memory)
        accelerator->load_before(loaded_before(config.memory_placement, stimulus));
    return accelerator;
}

RunStatistics simulate(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                       SimulationOptions const& options, SampleProbe* probe) {
    auto machine = std::make_shared<Machine const>(make_machine(describe_raster_core(config), config));
    return simulate(*make_accelerator(config, stimulus, std::move(machine), engine, probe), options);
}

}  // namespace faster
