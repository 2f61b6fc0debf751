#include "simulation/simulate.hpp"

#include <systemc>

#include "modules/accelerator.hpp"
#include "retiming/collect.hpp"
#include "simulation/recordings.hpp"
#include "simulation/taping.hpp"
#include "simulation/trace_path.hpp"

namespace faster {

namespace {
std::vector<retiming::FinishedCore> finished_cores(Accelerator const& accelerator) {
    std::vector<retiming::FinishedCore> cores;
    for (auto const& core : accelerator.cores())
        cores.push_back({core->share(), core->timing(), core->result_collector.results().data()});
    return cores;
}
}  // namespace

RunStatistics simulate(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                       SimulationOptions const& options) {
    Accelerator accelerator("accelerator", config, stimulus, engine);
    std::uint64_t done = 0;
    for (auto const& core : accelerator.cores()) {
        core->set_probe(options.probe);
        if (options.progress)
            core->set_progress([&done, &options] { options.progress(++done); });
        if (options.critical_path)
            core->timing().leave_trail(options.trail_length);
    }
    Recordings recordings(accelerator, options.recordings);
    std::unique_ptr<Taping> const taping =
        options.recorded == nullptr ? nullptr : std::make_unique<Taping>(accelerator, *options.recorded);
    sc_core::sc_start();
    for (auto const& core : accelerator.cores())
        core->timing().resolve();
    RunStatistics run = retiming::collect(finished_cores(accelerator), config);
    if (taping && !run.deadlocked())
        taping->finish();
    if (options.critical_path && !run.deadlocked())
        run.critical_path = trace_path(accelerator);
    recordings.finish(run.deadlocked() ? run.deadlock_cycle() + 1 : run.total_cycles);
    return run;
}

}  // namespace faster
