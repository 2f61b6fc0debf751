#include "kernel/replay/retime_together.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "kernel/machine/core_share.hpp"
#include "kernel/replay/collect.hpp"
#include "kernel/replay/core_variant.hpp"
#include "kernel/replay/critical_path_of.hpp"
#include "kernel/replay/plain_reader.hpp"
#include "kernel/replay/retime.hpp"
#include "kernel/replay/sample_cutter.hpp"
#include "kernel/timing/memory/memory_system.hpp"

namespace faster::replay {

namespace {

/// Samples as operations, from a script as long as there is one.
class PlainSamples {
  public:
    explicit PlainSamples(ScriptedRun const& run) : run_(run), lead_(*run.run().blueprint, run.lead()) {}

    SampleOperations read(std::size_t sample) {
        if (sample < run_.size())
            return joined(run_[sample], run_.book(), lead_.group);
        if (reader_ == nullptr)
            reader_ = std::make_unique<PlainReader>(run_.run(), run_.lead());
        return reader_->read(sample);
    }

  private:
    ScriptedRun const& run_;
    LeadCore lead_;
    std::unique_ptr<PlainReader> reader_;
};

std::uint64_t tokens_of(timing::MemoryEntry const& entry) {
    std::uint64_t tokens = 0;
    for (timing::MemoryBlock const& block : entry.blocks)
        tokens += block.all_tokens();
    return tokens;
}

class Together {
  public:
    Together(ScriptedRun const& run, Machine const& machine, bool leave_trails, CoreWatch* watch)
        : run_(run), machine_(machine), leave_trails_(leave_trails), watch_(watch), samples_(run) {
        if (machine.external_memory)
            memory_.emplace(*machine.external_memory, masters_of(machine));
        auto const automaton = std::make_shared<timing::Automaton>();
        for (std::size_t core = 0; core < machine.cores; ++core) {
            shares_.push_back(share_of(core, machine.cores, run.run().tape.samples()));
            cores_.push_back(core_variant(*run.run().blueprint, machine));
            cores_.back()->let_follow(run.lead(), automaton);
            if (leave_trails)
                cores_.back()->leave_trail();
            if (memory_)
                memory_->add_core(*cores_.back(), shares_.back().count > 0);
        }
        for (std::size_t core = 0; watch != nullptr && core < cores_.size(); ++core)
            watch->start(core, *cores_[core]);
        for (std::size_t core = 0; memory_ && core < cores_.size(); ++core)
            tell_entries(core);
    }

    RunStatistics go_on() {
        for (std::size_t i = 0; i < shares_.front().count; ++i)  // the first has the most
            for (std::size_t core = 0; core < cores_.size(); ++core)
                if (i < shares_[core].count && !feed(core, i))
                    return {};
        if (memory_)
            memory_->go_on(true);
        std::vector<FinishedCore> finished;
        for (std::size_t core = 0; core < cores_.size(); ++core) {
            cores_[core]->resolve();
            finished.push_back({shares_[core], *cores_[core], run_.run().counters.data() + shares_[core].first});
        }
        if (watch_ != nullptr)
            watch_->end();
        RunStatistics statistics = collect(finished, machine_, memory_ ? &*memory_ : nullptr, recorded().loaded);
        if (leave_trails_ && !statistics.deadlocked())
            statistics.critical_path = path();
        return statistics;
    }

  private:
    RecordedMemory const& recorded() const { return *run_.run().memory; }

    CriticalPath path() const {
        std::vector<timing::CoreTiming const*> cores;
        for (auto const& core : cores_)
            cores.push_back(core.get());
        return critical_path_of(cores, machine_);
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

    /// False: nobody wants to know more.
    bool feed(std::size_t core, std::size_t i) {
        if (watch_ != nullptr && !watch_->sample_begins(core, i))
            return false;
        std::size_t const sample = shares_[core].first + i;
        if (!memory_)
            deliver_all(core, sample);
        SampleOperations const operations = samples_.read(sample);
        for (std::size_t process = 0; process < operations.size(); ++process)
            tell_sample(operations[process], cores_[core]->process(process));
        if (memory_)
            memory_->note_sample();
        else
            cores_[core]->resolve(false);
        return true;
    }

    void deliver_all(std::size_t core, std::size_t sample) {
        auto const& masters = recorded().entries[sample];
        for (std::size_t master = 0; master < masters.size(); ++master) {
            timing::MemoryStream& stream = cores_[core]->stream(master);
            stream.forget_taken(stream.is_write() ? 0 : stream.taken());
            for (timing::MemoryEntry const& entry : masters[master])
                stream.deliver(stream.is_write() ? 0 : tokens_of(entry), 0);
        }
    }

    ScriptedRun const& run_;
    Machine const& machine_;
    bool leave_trails_;
    CoreWatch* watch_;
    PlainSamples samples_;
    std::vector<CoreShare> shares_;
    Cores cores_;
    std::optional<timing::MemorySystem> memory_;
};

}  // namespace

RunStatistics retime_together(ScriptedRun const& run, Machine const& machine, bool leave_trails, CoreWatch* watch) {
    return Together(run, machine, leave_trails, watch).go_on();
}

}  // namespace faster::replay
