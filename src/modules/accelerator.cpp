#include "modules/accelerator.hpp"

#include <string>

#include "modules/core_shapes.hpp"

namespace faster {

Accelerator::Accelerator(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
                         Engine engine)
    : sc_module(name) {
    TimeBase const time_base{engine, config.clock_mhz};
    auto const automaton = std::make_shared<timing::Automaton>();  // the cores are all alike
    for (std::size_t core = 0; core < config.raster_cores; ++core) {
        CoreShare const share = share_of(core, config.raster_cores, stimulus.samples.size());
        std::string const core_name = "core_" + std::to_string(core);
        cores_.push_back(std::make_unique<RasterCore>(core_name.c_str(), config, stimulus, share, time_base));
        if (engine == Engine::lockstep)
            continue;
        cores_.back()->timing().let_follow(rasterizer_and_followers(Parts(config)), automaton);
        if (core > 0)
            cores_[core]->run_after(*cores_[core - 1]);
    }
}

CoreShare Accelerator::share_of(std::size_t core, std::size_t cores, std::size_t samples) {
    return faster::share_of(core, cores, samples);
}

}  // namespace faster
