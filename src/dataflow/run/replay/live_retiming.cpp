#include "dataflow/run/replay/live_retiming.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dataflow/run/replay/collect.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/sample_cutter.hpp"

namespace dataflow::replay {

class LiveRetiming::Window : public ScriptSource {
  public:
    Window(timing::PhraseBook const& book, std::size_t first) : book_(book), first_(first) {}

    timing::PhraseBook const& book() const override { return book_; }
    std::size_t size() const override { return first_ + samples_.size(); }
    ScriptedSample const& operator[](std::size_t sample) const override { return samples_[sample - first_]; }
    void put(ScriptedSample sample) { samples_.push_back(std::move(sample)); }
    void forget_before(std::size_t sample) {
        for (; first_ < sample && !samples_.empty(); ++first_)
            samples_.pop_front();
    }

  private:
    timing::PhraseBook const& book_;
    std::size_t first_;
    std::deque<ScriptedSample> samples_;
};

struct LiveRetiming::Core {
    Core(CoreShare its_share, timing::PhraseBook const& book, timing::Lead const& lead,
         std::unique_ptr<timing::PhraseCore> its_timing)
        : share(its_share),
          timing(std::move(its_timing)),
          window(book, share.first),
          replay(
              window, [this](std::size_t /*sample*/) { return std::move(plain); }, share, *timing, lead) {}

    /// As far as the next sample is known as well: the supplier is a sample ahead.
    void put(ScriptedSample scripted) {
        window.put(std::move(scripted));
        std::size_t const end = window.size();
        std::size_t const sure = end == share.first + share.count ? end : end - 1;
        replay.go_on_to(sure);
        window.forget_before(sure);
    }
    /// Nothing is scripted from the sample on.
    void put(std::size_t sample, SampleOperations operations) {
        replay.go_on_to(sample);
        window.forget_before(sample);
        plain = std::move(operations);
        replay.go_on_to(sample + 1);
    }

    CoreShare share;
    std::unique_ptr<timing::PhraseCore> timing;
    Window window;
    SampleOperations plain;  ///< of the sample at hand, if it is not scripted
    Replay replay;
};

LiveRetiming::LiveRetiming(timing::CoreTiming const& blueprint, Machine const& machine,
                           std::vector<CoreShare> const& shares)
    : machine_(machine), lead_(blueprint, machine.lead), cutter_(blueprint, machine.lead) {
    std::shared_ptr<timing::Answers> const answers = timing::make_answers();
    for (CoreShare const& share : shares) {
        std::unique_ptr<timing::PhraseCore> timing = core_variant(blueprint, machine);
        timing->let_follow(machine.lead, answers);
        cores_.push_back(std::make_unique<Core>(share, book_, machine.lead, std::move(timing)));
    }
}

LiveRetiming::~LiveRetiming() = default;

LiveRetiming::Core& LiveRetiming::core_of(std::size_t sample) {
    auto const has_it = [sample](std::unique_ptr<Core> const& core) {
        return sample >= core->share.first && sample < core->share.first + core->share.count;
    };
    auto const core = std::find_if(cores_.begin(), cores_.end(), has_it);
    if (core == cores_.end())
        throw std::logic_error("a sample of no core");
    return **core;
}

void LiveRetiming::put(std::size_t sample, ScriptedSample scripted, timing::PhraseBook const& book) {
    Core& core = core_of(sample);
    is_stuck_ = is_stuck_ || core.replay.is_stuck();
    if (is_stuck_)
        return;
    if (book_.bytes() > most_bytes_of_phrases) {
        core.put(sample, joined(scripted, book, lead_.group));
        return;
    }
    std::size_t const known = book_.size();
    scripted.renumber(book_.numbers_of(book));
    cutter_.cut_from(book_, known);
    core.put(std::move(scripted));
}

std::optional<RunStatistics> LiveRetiming::finish(std::vector<Counters> const& counters) {
    std::vector<FinishedCore> cores;
    for (std::unique_ptr<Core> const& core : cores_) {
        if (is_stuck_ || core->replay.is_stuck())
            return std::nullopt;
        core->timing->resolve();
        cores.push_back({core->share, *core->timing, counters.data() + core->share.first});
    }
    RunStatistics run = collect(cores, machine_);
    if (run.deadlocked())
        return std::nullopt;
    return run;
}

}  // namespace dataflow::replay
