#include "simulation/simulate.hpp"

#include <systemc>

#include "modules/accelerator.hpp"
#include "simulation/collect.hpp"
#include "simulation/recordings.hpp"

namespace faster {

RunStatistics simulate(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                       SimulationOptions const& options) {
    Accelerator accelerator("accelerator", config, stimulus, engine);
    std::uint64_t done = 0;
    for (auto const& core : accelerator.cores()) {
        core->set_probe(options.probe);
        if (options.progress)
            core->set_progress([&done, &options] { options.progress(++done); });
    }
    Recordings recordings(accelerator, options.recordings);
    sc_core::sc_start();
    for (auto const& core : accelerator.cores())
        core->timing().resolve();
    RunStatistics run = collect(accelerator, config, stimulus);
    recordings.finish(run.deadlocked() ? run.deadlock_cycle() + 1 : run.total_cycles);
    return run;
}

}  // namespace faster
