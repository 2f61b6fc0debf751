#include "retiming/retime.hpp"

#include <algorithm>
#include <memory>

#include "config/core_share.hpp"
#include "modules/core_shapes.hpp"
#include "retiming/collect.hpp"
#include "retiming/core_variant.hpp"

namespace faster::retiming {

namespace {

/// Lets one core do the operations of its samples, one sample after the other.
class Replay {
  public:
    Replay(OperationTape const& tape, ScriptedRun const* scripts, CoreShare share, timing::CoreTiming& core)
        : tape_(tape), scripts_(scripts), share_(share), core_(core), is_stuck_(core.processes().size(), false) {}

    void feed_all() {
        for (std::size_t i = 0; i < share_.count; ++i)
            feed(share_.first + i);
        core_.resolve();
    }

  private:
    static constexpr std::size_t usual_backlog = std::size_t{1} << 18;  // operations: a few samples' worth
    static constexpr std::size_t supplier = index_of(ModuleId::vertex_transform);

    void feed(std::size_t sample) {
        bool const is_stuck = std::find(is_stuck_.begin(), is_stuck_.end(), true) != is_stuck_.end();
        if (scripts_ != nullptr && sample < scripts_->size() && !is_stuck)
            feed((*scripts_)[sample], sample);
        else
            feed_plain(sample);
        core_.resolve(false);
        if (backlog() > usual_backlog)
            find_stuck();
    }

    void feed_plain(std::size_t sample) {
        tape_.read(sample, core_, operations_);
        for (std::size_t i = 0; i < operations_.size(); ++i)
            if (!is_stuck_[i] && !(i == supplier && sample < supplied_))
                append(operations_[i], core_.process(i).log());
    }

    void feed(ScriptedSample const& scripted, std::size_t sample) {
        for (std::size_t i = 0; i < scripted.before.size(); ++i)
            if (i != supplier)
                append(scripted.before[i], core_.process(i).log());
        supply(sample + 2);
        timing::Script script = scripted.script;
        script.book = &scripts_->book();
        script.next = scripted.phrases.data();
        script.end = script.next + scripted.phrases.size();
        core_.resolve(script);
        for (std::size_t i = 0; i < scripted.after.size(); ++i)
            for (timing::Operation const& operation : scripted.after[i])
                core_.process(i).log().append(operation);
    }

    /// The supplier is a sample ahead, so that what it goes on with after the one at hand is known.
    void supply(std::size_t end) {
        std::size_t const last = std::min({end, share_.first + share_.count, scripts_->size()});
        for (supplied_ = std::max(supplied_, share_.first); supplied_ < last; ++supplied_)
            append((*scripts_)[supplied_].before[supplier], core_.process(supplier).log());
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

    OperationTape const& tape_;
    ScriptedRun const* scripts_;
    CoreShare share_;
    timing::CoreTiming& core_;
    SampleOperations operations_;
    std::vector<bool> is_stuck_;
    std::size_t supplied_ = 0;  ///< samples whose vertices have been asked for
};

using Automaton = std::shared_ptr<timing::Automaton>;

std::unique_ptr<timing::CoreTiming> retime_core(RecordedRun const& run, ScriptedRun const* scripts,
                                                AcceleratorConfig const& config, std::size_t core, Automaton automaton,
                                                bool leaves_trail) {
    std::unique_ptr<timing::CoreTiming> timing = core_variant(*run.blueprint, config);
    timing->let_follow(rasterizer_and_followers(Parts(config)), std::move(automaton));
    if (leaves_trail)
        timing->leave_trail();
    CoreShare const share = share_of(core, config.raster_cores, run.tape.samples());
    Replay(run.tape, scripts, share, *timing).feed_all();
    return timing;
}

RunStatistics retime(RecordedRun const& run, ScriptedRun const* scripts, AcceleratorConfig const& config) {
    auto const automaton = std::make_shared<timing::Automaton>();
    std::vector<std::unique_ptr<timing::CoreTiming>> timings;
    std::vector<FinishedCore> cores;
    for (std::size_t k = 0; k < config.raster_cores; ++k) {
        timings.push_back(retime_core(run, scripts, config, k, automaton, false));
        CoreShare const share = share_of(k, config.raster_cores, run.tape.samples());
        cores.push_back({share, *timings.back(), run.counters.data() + share.first});
    }
    return collect(cores, config);
}

}  // namespace

std::unique_ptr<timing::CoreTiming> retime_core(RecordedRun const& run, AcceleratorConfig const& config,
                                                std::size_t core, Automaton automaton, bool leaves_trail) {
    return retime_core(run, nullptr, config, core, std::move(automaton), leaves_trail);
}

std::unique_ptr<timing::CoreTiming> retime_core(ScriptedRun const& run, AcceleratorConfig const& config,
                                                std::size_t core, Automaton automaton, bool leaves_trail) {
    return retime_core(run.run(), &run, config, core, std::move(automaton), leaves_trail);
}

RunStatistics retime(RecordedRun const& run, AcceleratorConfig const& config) { return retime(run, nullptr, config); }

RunStatistics retime(ScriptedRun const& run, AcceleratorConfig const& config) {
    RunStatistics statistics = retime(run.run(), &run, config);
    // Since when a process has waited is not always known where a script went on with operations of its left over. Only
    // reports of deadlocks tell.
    return statistics.deadlocked() ? retime(run.run(), config) : statistics;
}

}  // namespace faster::retiming
