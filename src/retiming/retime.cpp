#include "retiming/retime.hpp"

#include <memory>
#include <numeric>

#include "config/core_share.hpp"
#include "modules/core_shapes.hpp"
#include "retiming/collect.hpp"
#include "retiming/core_variant.hpp"
#include "retiming/plain_reader.hpp"
#include "retiming/replay.hpp"

namespace faster::retiming {

namespace {

enum class Following { scripts, logs };

/// Lets several cores take turns with walking, while one of them has to.
void feed_all(std::vector<std::unique_ptr<Replay>> const& replays, timing::Automaton& automaton) {
    std::vector<Replay*> walking;
    std::vector<timing::Automaton::Walk*> walks;
    for (std::unique_ptr<Replay> const& replay : replays)
        if (replay->go_on()) {
            walking.push_back(replay.get());
            walks.push_back(&replay->walk());
        }
    while (!walks.empty()) {
        std::size_t const stopped = automaton.go_on(walks);
        if (walking[stopped]->go_on())
            continue;
        walking.erase(walking.begin() + static_cast<std::ptrdiff_t>(stopped));
        walks.erase(walks.begin() + static_cast<std::ptrdiff_t>(stopped));
    }
}

/// Opens the tape when first asked.
Replay::Plain plain_reader(ScriptedRun const& run) {
    return [&run, reader = std::shared_ptr<PlainReader>()](std::size_t sample) mutable {
        if (reader == nullptr)
            reader = std::make_shared<PlainReader>(run.run(), run.parts());
        return reader->read(sample);
    };
}

Cores retime_cores(ScriptedRun const& run, Following following, AcceleratorConfig const& config,
                   std::vector<std::size_t> const& numbers, CoreOptions const& options) {
    static NoScripts const no_scripts;
    ScriptSource const& source = following == Following::scripts ? static_cast<ScriptSource const&>(run) : no_scripts;
    auto const automaton = std::make_shared<timing::Automaton>();
    Cores cores;
    std::vector<std::unique_ptr<Replay>> replays;
    for (std::size_t const number : numbers) {
        cores.push_back(core_variant(*run.run().blueprint, config));
        cores.back()->let_follow(rasterizer_and_followers(Parts(config)), automaton);
        if (options.leave_trails)
            cores.back()->leave_trail();
        CoreShare const share = share_of(number, config.raster_cores, run.run().tape.samples());
        replays.push_back(std::make_unique<Replay>(source, plain_reader(run), share, *cores.back(), options.leaves));
    }
    feed_all(replays, *automaton);
    return cores;
}

RunStatistics retime(ScriptedRun const& run, Following following, AcceleratorConfig const& config) {
    std::vector<std::size_t> numbers(config.raster_cores);
    std::iota(numbers.begin(), numbers.end(), 0U);
    Cores const timings = retime_cores(run, following, config, numbers, {});
    std::vector<FinishedCore> cores;
    for (std::size_t const k : numbers) {
        CoreShare const share = share_of(k, config.raster_cores, run.run().tape.samples());
        cores.push_back({share, *timings[k], run.run().counters.data() + share.first});
    }
    return collect(cores, config);
}

}  // namespace

Cores retime_cores(ScriptedRun const& run, AcceleratorConfig const& config, std::vector<std::size_t> const& cores,
                   CoreOptions const& options) {
    return retime_cores(run, Following::scripts, config, cores, options);
}

RunStatistics retime(RecordedRun const& run, AcceleratorConfig const& config) {
    return retime(ScriptedRun(run, Parts(config)), config);
}

RunStatistics retime(ScriptedRun const& run, AcceleratorConfig const& config) {
    RunStatistics statistics = retime(run, Following::scripts, config);
    // Since when a process has waited is not always known where a script went on with operations of its left over. Only
    // reports of deadlocks tell.
    return statistics.deadlocked() ? retime_unscripted(run, config) : statistics;
}

RunStatistics retime_unscripted(ScriptedRun const& run, AcceleratorConfig const& config) {
    return retime(run, Following::logs, config);
}

}  // namespace faster::retiming
