#include "retiming/retime.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "config/core_share.hpp"
#include "modules/core_shapes.hpp"
#include "retiming/collect.hpp"
#include "retiming/core_variant.hpp"
#include "retiming/sample_cutter.hpp"

namespace faster::retiming {

namespace {

enum class Following { scripts, logs };

/// Reads samples from the tape as operations, no phrases.
class PlainReader {
  public:
    explicit PlainReader(ScriptedRun const& run)
        : tape_(run.run().tape), known_(LeadCore(*run.run().blueprint, run.parts())) {}

    SampleOperations read(std::size_t sample) {
        return joined(tape_.read(sample, known_), known_.book(), known_.lead().group);
    }

  private:
    OperationTape const& tape_;
    KnownPhrases known_;
};

/// Lets one core do the operations of its samples, one sample after the other.
class Replay {
  public:
    Replay(ScriptedRun const& run, Following following, CoreShare share, timing::CoreTiming& core, Leaves leaves)
        : run_(run),
          following_(following),
          share_(share),
          core_(core),
          leaves_(std::move(leaves)),
          is_stuck_(core.processes().size(), false) {}

    /// As far as a walk of the core, or a walk further; false: all is done, or left.
    bool go_on() {
        if (is_walking_)
            core_.arrive();
        for (; fed_ < share_.count; ++fed_) {
            is_walking_ = is_walking_ || begin_script(share_.first + fed_);
            is_walking_ = is_walking_ && core_.set_out();
            if (is_walking_)
                return true;
            end_sample(share_.first + fed_);
            if (leaves_ && leaves_(core_))
                break;
        }
        core_.resolve();
        return false;
    }
    timing::Automaton::Walk& walk() { return core_.walk(); }

  private:
    static constexpr std::size_t usual_backlog = std::size_t{1} << 18;  // operations: a few samples' worth
    static constexpr std::size_t supplier = index_of(ModuleId::vertex_transform);

    /// False if the sample has none that could be followed.
    bool begin_script(std::size_t sample) {
        bool const is_stuck = std::find(is_stuck_.begin(), is_stuck_.end(), true) != is_stuck_.end();
        is_scripted_ = following_ == Following::scripts && sample < run_.size() && !is_stuck;
        if (is_scripted_)
            take_up(run_[sample], sample);
        return is_scripted_;
    }

    void end_sample(std::size_t sample) {
        is_scripted_ ? feed_rest(run_[sample]) : feed_plain(sample);
        core_.resolve(false);
        if (backlog() > usual_backlog)
            find_stuck();
    }

    void feed_plain(std::size_t sample) {
        if (!plain_)
            plain_ = std::make_unique<PlainReader>(run_);
        SampleOperations const operations = plain_->read(sample);
        for (std::size_t i = 0; i < operations.size(); ++i)
            if (!is_stuck_[i] && !(i == supplier && sample < supplied_))
                append(operations[i], core_.process(i).log());
    }

    void take_up(ScriptedSample const& scripted, std::size_t sample) {
        for (std::size_t i = 0; i < scripted.before.size(); ++i)
            if (i != supplier)
                append(scripted.before[i], core_.process(i).log());
        supply(sample + 2);
        script_ = scripted.script;
        script_.book = &run_.book();
        script_.next = scripted.phrases.data();
        script_.end = script_.next + scripted.phrases.size();
        core_.take_up(script_);
    }

    void feed_rest(ScriptedSample const& scripted) {
        for (std::size_t i = 0; i < scripted.after.size(); ++i)
            for (timing::Operation const& operation : scripted.after[i])
                core_.process(i).log().append(operation);
    }

    /// The supplier is a sample ahead, so that what it goes on with after the one at hand is known.
    void supply(std::size_t end) {
        std::size_t const last = std::min({end, share_.first + share_.count, run_.size()});
        for (supplied_ = std::max(supplied_, share_.first); supplied_ < last; ++supplied_)
            append(run_[supplied_].before[supplier], core_.process(supplier).log());
    }

    /// The first may wait on from where the last sample ended: one wait then, as the process itself would have said it.
    static void append(std::vector<timing::Operation> const& operations, timing::OperationLog& log) {
        auto operation = operations.begin();
        if (operation != operations.end() && operation->kind() == timing::Operation::Kind::wait &&
            !operation->is_setup())
            log.wait((operation++)->count());
        for (; operation != operations.end(); ++operation)
            log.append(*operation);
    }

    std::size_t backlog() {
        std::size_t operations = 0;
        for (std::size_t i = 0; i < is_stuck_.size(); ++i)
            operations += is_stuck_[i] ? 0 : core_.process(i).log().pending();
        return operations;
    }

    /// All that samples so far want done has been logged. So what cannot be done now never will be, and what comes
    /// after it would only fill the memory. The supplier, which may be ahead, never has much of that.
    void find_stuck() {
        core_.resolve();
        for (std::size_t i = 0; i < is_stuck_.size(); ++i)
            is_stuck_[i] = i != supplier && !core_.processes()[i].finished();
    }

    ScriptedRun const& run_;
    Following following_;
    CoreShare share_;
    timing::CoreTiming& core_;
    Leaves leaves_;
    std::unique_ptr<PlainReader> plain_;
    std::vector<bool> is_stuck_;
    std::size_t supplied_ = 0;  ///< samples whose vertices have been asked for
    std::size_t fed_ = 0;       ///< samples done
    bool is_scripted_ = false;  ///< the sample at hand
    bool is_walking_ = false;
    timing::Script script_;
};

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
        if (automaton.find_out(*walks[stopped]) || walking[stopped]->go_on())
            continue;
        walking.erase(walking.begin() + static_cast<std::ptrdiff_t>(stopped));
        walks.erase(walks.begin() + static_cast<std::ptrdiff_t>(stopped));
    }
}

Cores retime_cores(ScriptedRun const& run, Following following, AcceleratorConfig const& config,
                   std::vector<std::size_t> const& numbers, CoreOptions const& options) {
    auto const automaton = std::make_shared<timing::Automaton>();
    Cores cores;
    std::vector<std::unique_ptr<Replay>> replays;
    for (std::size_t const number : numbers) {
        cores.push_back(core_variant(*run.run().blueprint, config));
        cores.back()->let_follow(rasterizer_and_followers(Parts(config)), automaton);
        if (options.leave_trails)
            cores.back()->leave_trail();
        CoreShare const share = share_of(number, config.raster_cores, run.run().tape.samples());
        replays.push_back(std::make_unique<Replay>(run, following, share, *cores.back(), options.leaves));
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
