#include "tb/simulation/simulate.hpp"

#include <optional>
#include <systemc>

#include "kernel/replay/collect.hpp"
#include "modules/accelerator.hpp"
#include "tb/simulation/recordings.hpp"
#include "tb/simulation/taping.hpp"
#include "tb/simulation/trace_path.hpp"

namespace faster {

namespace {
std::vector<retiming::FinishedCore> finished_cores(Accelerator const& accelerator) {
    std::vector<retiming::FinishedCore> cores;
    for (auto const& core : accelerator.cores())
        cores.push_back({core->share(), core->timing(), core->result_collector.results().data()});
    return cores;
}
/// A waveform and a critical path are told by the cores that keep the time.
Taping::Timing timing_of_taping(Engine engine, SimulationOptions const& options) {
    bool const asks_cores = engine == Engine::lockstep || options.critical_path || !options.recordings.empty();
    return asks_cores ? Taping::Timing::by_cores : Taping::Timing::from_tape;
}

/// Of a run that has come to its end, or is stuck.
RunStatistics statistics_of(Accelerator& accelerator, AcceleratorConfig const& config, Taping* taping) {
    bool const from_tape = taping != nullptr && taping->timing() == Taping::Timing::from_tape;
    if (from_tape) {
        taping->finish();
        if (std::optional<RunStatistics> run = taping->statistics())
            return *std::move(run);
    }
    for (auto const& core : accelerator.cores())
        core->timing().resolve();
    RunStatistics run = retiming::collect(finished_cores(accelerator), config);
    if (taping != nullptr && !from_tape && !run.deadlocked())
        taping->finish();
    return run;
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
    std::unique_ptr<Taping> taping;
    if (options.recorded != nullptr)
        taping = std::make_unique<Taping>(accelerator, config, *options.recorded, timing_of_taping(engine, options));
    sc_core::sc_start();
    RunStatistics run = statistics_of(accelerator, config, taping.get());
    if (options.critical_path && !run.deadlocked())
        run.critical_path = trace_path(accelerator);
    recordings.finish(run.deadlocked() ? run.deadlock_cycle() + 1 : run.total_cycles);
    return run;
}

}  // namespace faster
