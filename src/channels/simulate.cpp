#include "channels/simulate.hpp"

#include <algorithm>
#include <memory>
#include <system_error>

#include "channels/collect_from.hpp"
#include "channels/recordings.hpp"
#include "channels/simulate_in_parts.hpp"
#include "channels/taping.hpp"
#include "dataflow/base/worker.hpp"
#include "dataflow/run/replay/critical_path_of.hpp"
#include "dataflow/run/replay/path_sweep.hpp"

namespace dataflow {

namespace {
/// Whether the first core's samples have got their cycles. Not while a thread works them out.
bool has_done(DataflowAccelerator const& accelerator, std::size_t samples) {
    timing::CoreTiming const& timing = accelerator.cores().front()->timing();
    return timing.processes()[accelerator.machine().ends].stamps().size() >= samples;
}

/// Counts samples done, of all cores.
void watch_samples(DataflowAccelerator& accelerator, SimulationOptions const& options, std::uint64_t& done) {
    for (auto const& core : accelerator.cores())
        core->set_progress([&] {
            ++done;
            if (options.progress)
                options.progress(done);
            if (options.leaves_early() && has_done(accelerator, options.most_samples))
                accelerator.leave();
        });
}

/// Null: the kernel's own thread has to do it.
std::unique_ptr<Worker> timing_thread(DataflowAccelerator& accelerator, SimulationOptions const& options) {
    constexpr std::size_t most_operations = std::size_t{1} << 20;  // that wait for it, of 8 bytes
    if (options.jobs < 2 || options.looks_at_cycles() || accelerator.engine() != Engine::decoupled ||
        accelerator.memory() != nullptr)
        return nullptr;
    try {
        auto thread = std::make_unique<Worker>(most_operations);
        for (auto const& core : accelerator.cores())
            core->use_thread(*thread);
        return thread;
    } catch (std::system_error const&) {  // no more of them
        return nullptr;
    }
}

void finish(Worker& thread, DataflowAccelerator& accelerator) {
    for (auto const& core : accelerator.cores())
        core->catch_up();
    thread.finish();
}

Cycles latest_of(DataflowAccelerator const& accelerator) {
    Cycles latest = 0;
    for (auto const& core : accelerator.cores())
        for (timing::ProcessTiming const& process : core->timing().processes())
            latest = std::max(latest, process.local_time());
    return latest;
}
}  // namespace

RunStatistics simulate(DataflowAccelerator& accelerator, SimulationOptions const& options) {
    if (std::optional<RunStatistics> run = simulate_in_parts(accelerator, options))
        return std::move(*run);
    std::uint64_t done = 0;
    if (options.progress || options.leaves_early())
        watch_samples(accelerator, options, done);
    for (auto const& core : accelerator.cores()) {
        if (options.critical_path)
            core->timing().leave_trail(timing::forget_trunk, options.trail_length);
        if (options.hazards)
            core->watch_dependences();
    }
    Recordings recordings(accelerator, options.recordings);
    std::unique_ptr<Taping> taping;
    if (options.recorded != nullptr)
        taping = std::make_unique<Taping>(accelerator, *options.recorded);
    std::unique_ptr<Worker> const thread = timing_thread(accelerator, options);
    accelerator.run();
    if (thread != nullptr)
        finish(*thread, accelerator);
    if (accelerator.is_left()) {
        recordings.finish(latest_of(accelerator));
        return {};
    }
    RunStatistics run = collect_from(accelerator, 0, accelerator.cores().size());
    if (taping)
        taping->finish();
    if (options.critical_path && !run.deadlocked())
        run.critical_path = CriticalPath{
            run.last_core(),
            replay::critical_path_of(accelerator.cores()[run.last_core()]->timing(), accelerator.machine())};
    for (std::size_t i = 0; i < run.cores.size(); ++i)
        run.cores[i].dependences = accelerator.cores()[i]->dependences();
    recordings.finish(run.deadlocked() ? run.deadlock_cycle() + 1 : run.core_cycles());
    return run;
}

}  // namespace dataflow
