#include "dataflow/run/replay/retime.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/replay/collect.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/critical_path_of.hpp"
#include "dataflow/run/replay/outcomes.hpp"
#include "dataflow/run/replay/path_sweep.hpp"
#include "dataflow/run/replay/plain_reader.hpp"
#include "dataflow/run/replay/replay.hpp"
#include "dataflow/run/replay/retime_together.hpp"

namespace dataflow::replay {

namespace {

enum class Following { scripts, logs };

/// Lets several cores take turns with walking, while one of them has to.
void feed_all(std::vector<std::unique_ptr<Replay>> const& replays, timing::Answers* answers) {
    std::vector<Replay*> walking;
    std::vector<timing::PhraseCore*> cores;
    for (std::unique_ptr<Replay> const& replay : replays)
        if (replay->go_on()) {
            walking.push_back(replay.get());
            cores.push_back(&replay->core());
        }
    while (!cores.empty()) {
        std::size_t const stopped = answers->go_on(cores);
        if (walking[stopped]->go_on())
            continue;
        walking.erase(walking.begin() + static_cast<std::ptrdiff_t>(stopped));
        cores.erase(cores.begin() + static_cast<std::ptrdiff_t>(stopped));
    }
}

Replay::Plain plain_reader(ScriptedRun const& run) {
    return [reader = std::make_shared<PlainReader>(run.run())](std::size_t sample) { return reader->read(sample); };
}

Cores retime_cores(ScriptedRun const& run, Following following, Machine const& machine,
                   std::vector<std::size_t> const& numbers, CoreOptions const& options) {
    static ScriptSource const no_scripts;
    std::shared_ptr<timing::Answers> const answers = timing::make_answers();
    Cores cores;
    std::shared_ptr<ScriptSource const> samples;  // the same for all: cores are alike
    std::vector<std::unique_ptr<Replay>> replays;
    for (std::size_t const number : numbers) {
        cores.push_back(core_variant(*run.run().blueprint, machine));
        cores.back()->let_follow(run.lead(), answers);
        if (options.leave_trails)
            cores.back()->leave_trail(timing::forget_trunk);
        CoreShare const share = share_of(number, machine.cores, run.run().tape.samples());
        if (samples == nullptr && following == Following::scripts)
            samples = run.samples_for(*cores.back(), machine);
        replays.push_back(std::make_unique<Replay>(samples ? *samples : no_scripts, plain_reader(run), share,
                                                   *cores.back(), run.lead(), options.leaves));
    }
    feed_all(replays, answers.get());
    require_outcomes(cores, options.leaves == nullptr);
    return cores;
}

/// Each thread has some of the cores, which remember together what they have worked out.
Cores retime_all_cores(ScriptedRun const& run, Following following, Machine const& machine, std::size_t jobs) {
    Cores all(machine.cores);
    jobs = std::min<std::size_t>(jobs, machine.cores);
    on_threads(jobs, jobs, [&](std::size_t job) {
        std::vector<std::size_t> numbers;
        for (std::size_t core = job; core < machine.cores; core += jobs)
            numbers.push_back(core);
        Cores some = retime_cores(run, following, machine, numbers, {});
        for (std::size_t i = 0; i < numbers.size(); ++i)
            all[numbers[i]] = std::move(some[i]);
    });
    return all;
}

RunStatistics retime(ScriptedRun const& run, Following following, Machine const& machine, std::size_t jobs) {
    Cores const timings = retime_all_cores(run, following, machine, jobs);
    std::vector<FinishedCore> cores;
    for (std::size_t k = 0; k < timings.size(); ++k) {
        CoreShare const share = share_of(k, machine.cores, run.run().tape.samples());
        cores.push_back({share, *timings[k], run.run().counters.data() + share.first});
    }
    return collect(cores, machine);
}

}  // namespace

Cores retime_cores(ScriptedRun const& run, Machine const& machine, std::vector<std::size_t> const& cores,
                   CoreOptions const& options) {
    if (run.run().memory)
        return retime_cores_together(run, machine, cores, options);
    return retime_cores(run, Following::scripts, machine, cores, options);
}

RunStatistics retime(RecordedRun const& run, Machine const& machine) {
    return retime(ScriptedRun(run, ScriptedRun::Uses::few), machine);
}

RunStatistics retime(ScriptedRun const& run, Machine const& machine, std::size_t jobs) {
    if (run.run().memory)
        return retime_together(run, machine);
    RunStatistics statistics = retime(run, Following::scripts, machine, jobs);
    // Since when a process has waited is not always known where a script went on with operations of its left over. Only
    // reports of deadlocks tell.
    return statistics.deadlocked() ? retime_unscripted(run, machine) : statistics;
}

RunStatistics retime_with_path(ScriptedRun const& scripted, Machine const& machine) {
    if (scripted.run().memory)
        return retime_together(scripted, machine, true);
    RunStatistics run = retime(scripted, machine);
    if (run.deadlocked())
        return run;
    CoreOptions options;
    options.leave_trails = true;
    Cores const cores = retime_cores(scripted, machine, {run.last_core()}, options);
    run.critical_path = CriticalPath{run.last_core(), critical_path_of(*cores.front(), machine)};
    return run;
}

RunStatistics retime_unscripted(ScriptedRun const& run, Machine const& machine) {
    return retime(run, Following::logs, machine, 1);
}

}  // namespace dataflow::replay
