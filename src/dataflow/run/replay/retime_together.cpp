#include "dataflow/run/replay/retime_together.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <numeric>
#include <optional>

#include "dataflow/base/core_share.hpp"
#include "dataflow/core/memory/memory_system.hpp"
#include "dataflow/run/replay/collect.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/critical_path_of.hpp"
#include "dataflow/run/replay/outcomes.hpp"
#include "dataflow/run/replay/path_sweep.hpp"
#include "dataflow/run/replay/plain_reader.hpp"
#include "dataflow/run/replay/sample_cutter.hpp"
#include "dataflow/run/replay/scripted_core.hpp"

namespace dataflow::replay {

namespace {

/// Samples as operations, from a script as long as there is one.
class PlainSamples {
  public:
    explicit PlainSamples(ScriptedRun const& run)
        : run_(run), lead_(*run.run().blueprint, run.lead()), reader_(run.run()) {}

    SampleOperations read(std::size_t sample) {
        return sample < run_.size() ? joined(run_[sample], run_.book(), lead_.group) : reader_.read(sample);
    }

  private:
    ScriptedRun const& run_;
    LeadCore lead_;
    PlainReader reader_;
};

enum class Source { scripts, operations };

/// Of all samples, if they say the most of them.
bool can_follow_scripts(ScriptedRun const& run, Machine const& machine) {
    if (!machine.external_memory || run.lead().followers.empty() || run.size() != run.run().tape.samples())
        return false;
    std::size_t phrases = 0, operations_behind = 0;
    for (std::size_t sample = 0; sample < run.size(); ++sample) {
        phrases += run[sample].phrases.size();
        for (std::vector<timing::Operation> const& process : run[sample].after)
            operations_behind += process.size();
    }
    constexpr std::size_t usual_behind = 64;  // of a sample
    return operations_behind <= phrases + usual_behind * run.size();
}

class Together {
  public:
    Together(ScriptedRun const& run, Machine const& machine, std::vector<std::size_t> const& numbers,
             CoreOptions const& options, Source source, CoreWatch* watch = nullptr)
        : run_(run), machine_(machine), options_(options), watch_(watch), samples_(run), is_left_(numbers.size()) {
        if (machine.external_memory)
            memory_.emplace(*machine.external_memory, masters_of(machine));
        std::shared_ptr<timing::Answers> const answers = timing::make_answers();
        for (std::size_t const number : numbers) {
            shares_.push_back(share_of(number, machine.cores, run.run().samples()));
            cores_.push_back(core_variant(*run.run().blueprint, machine));
            cores_.back()->let_follow(run.lead(), answers);
            if (options.leave_trails)
                cores_.back()->leave_trail(timing::forget_trunk);
        }
        for (std::size_t core = 0; memory_ && core < cores_.size(); ++core)
            source == Source::scripts ? add_scripted(core) : memory_->add_core(*cores_[core], shares_[core].count > 0);
        for (std::size_t core = 0; watch != nullptr && core < cores_.size(); ++core)
            watch->start(core, *cores_[core]);
        for (std::size_t core = 0; memory_ && core < cores_.size(); ++core)
            tell_entries(core);
    }

    /// False: the watch wants to know no more.
    bool go_on() {
        for (std::size_t i = 0; scripted_.empty() && i < shares_.front().count && has_more();
             ++i) {  // the first has the most
            for (std::size_t core = 0; core < cores_.size(); ++core)
                if (i < shares_[core].count && !is_left_[core] && !feed(core, i))
                    return false;
            if (memory_)
                memory_->go_on(false);
            leave();
        }
        for (auto const& core : cores_)
            tell_end(*core);
        if (memory_)
            memory_->go_on(true);
        for (auto const& core : cores_)
            core->resolve();
        if (watch_ != nullptr)
            watch_->end();
        return true;
    }

    RunStatistics statistics() const {
        require_outcomes(cores_, true);
        std::vector<FinishedCore> finished;
        for (std::size_t core = 0; core < cores_.size(); ++core)
            finished.push_back({shares_[core], *cores_[core], run_.run().counters.data() + shares_[core].first});
        RunStatistics statistics = collect(finished, machine_, memory_ ? &*memory_ : nullptr, recorded().loaded);
        if (options_.leave_trails && !statistics.deadlocked())
            statistics.critical_path =
                CriticalPath{statistics.last_core(), critical_path_of(*cores_[statistics.last_core()], machine_)};
        return statistics;
    }

    Cores take_cores() {
        require_outcomes(cores_, options_.leaves == nullptr);
        return std::move(cores_);
    }
    /// It may have served memory in another order than there is: to be done again without scripts.
    bool is_in_doubt() const {
        return std::any_of(scripted_.begin(), scripted_.end(),
                           [](ScriptedCore const& core) { return core.has_more_to_say(); });
    }

  private:
    RecordedMemory const& recorded() const { return *run_.run().memory; }
    bool has_more() const { return std::find(is_left_.begin(), is_left_.end(), false) != is_left_.end(); }

    void add_scripted(std::size_t core) {
        if (scripts_ == nullptr)
            scripts_ = run_.samples_for(*cores_[core], machine_);
        ScriptedCore& scripted =
            scripted_.emplace_back(*scripts_, run_.lead(), shares_[core], *cores_[core],
                                   [this](timing::CoreTiming const& timing) { return leaves(timing); });
        memory_->add_core(*cores_[core], shares_[core].count > 0,
                          [&scripted](timing::ProcessMask woken) { scripted.go_on(woken); });
    }

    /// Where one is left that shares the memory, all are.
    bool leaves(timing::CoreTiming const& timing) {
        bool const leaves = options_.leaves && options_.leaves(timing);
        is_left_.front() = is_left_.front() || leaves;
        return memory_->shape().is_shared ? is_left_.front() : leaves;
    }

    void leave() {
        for (std::size_t core = 0; options_.leaves && core < cores_.size(); ++core)
            is_left_[core] = is_left_[core] || options_.leaves(*cores_[core]);
        if (memory_ && memory_->shape().is_shared &&
            std::find(is_left_.begin(), is_left_.end(), true) != is_left_.end())
            is_left_.assign(is_left_.size(), true);
    }

    /// All at once: who prefetches asks for them before their process comes there.
    void tell_entries(std::size_t core) {
        for (std::size_t i = 0; i < shares_[core].count; ++i) {
            auto const& masters = recorded().entries[shares_[core].first + i];
            for (std::size_t master = 0; master < masters.size(); ++master)
                for (timing::MemoryEntry entry : masters[master]) {
                    entry.sample = i;
                    memory_->add(core, master, std::move(entry));
                }
        }
    }

    bool feed(std::size_t core, std::size_t i) {
        if (watch_ != nullptr && !watch_->sample_begins(core, i))
            return false;
        std::size_t const sample = shares_[core].first + i;
        if (!memory_)
            deliver_all(core, sample);
        SampleOperations const operations = samples_.read(sample);
        for (std::size_t process = 0; process < operations.size(); ++process)
            tell_sample(operations[process], cores_[core]->process(process));
        if (!memory_)
            cores_[core]->resolve(false);
        return true;
    }

    void deliver_all(std::size_t core, std::size_t sample) {
        auto const& masters = recorded().entries[sample];
        for (std::size_t master = 0; master < masters.size(); ++master) {
            timing::MemoryStream& stream = cores_[core]->stream(master);
            stream.forget_taken(stream.is_write() ? 0 : stream.taken());
            for (timing::MemoryEntry const& entry : masters[master])
                stream.deliver_at_once(stream.is_write() ? 0 : entry.all_tokens());
        }
    }

    ScriptedRun const& run_;
    Machine const& machine_;
    CoreOptions const options_;
    CoreWatch* watch_;
    PlainSamples samples_;
    std::vector<CoreShare> shares_;
    Cores cores_;
    std::optional<timing::MemorySystem> memory_;
    std::shared_ptr<ScriptSource const> scripts_;
    std::deque<ScriptedCore> scripted_;
    std::vector<bool> is_left_;  // by core
};

}  // namespace

RunStatistics retime_together(ScriptedRun const& run, Machine const& machine, bool leave_trails, CoreWatch* watch) {
    std::vector<std::size_t> numbers(machine.cores);
    std::iota(numbers.begin(), numbers.end(), 0U);
    if (!leave_trails && watch == nullptr && can_follow_scripts(run, machine)) {
        Together together(run, machine, numbers, {}, Source::scripts);
        together.go_on();
        RunStatistics statistics = together.statistics();
        if (!together.is_in_doubt() && !statistics.deadlocked())
            return statistics;
    }
    Together together(run, machine, numbers, {leave_trails, nullptr}, Source::operations, watch);
    return together.go_on() ? together.statistics() : RunStatistics();
}

Cores retime_cores_together(ScriptedRun const& run, Machine const& machine, std::vector<std::size_t> const& cores,
                            CoreOptions const& options) {
    for (Source const source : {Source::scripts, Source::operations}) {
        if (source == Source::scripts && (options.leave_trails || !can_follow_scripts(run, machine)))
            continue;
        Together together(run, machine, cores, options, source);
        together.go_on();
        if (!together.is_in_doubt())
            return together.take_cores();
    }
    return {};
}

}  // namespace dataflow::replay
