#include "dataflow/tools/explore/replayed_timeline.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/core_watch.hpp"
#include "dataflow/run/replay/plain_reader.hpp"
#include "dataflow/run/replay/retime_together.hpp"
#include "dataflow/tools/recording/core_recorder.hpp"
#include "dataflow/tools/recording/core_timeline.hpp"

namespace dataflow::explore {

namespace {

/// A core that does again what was recorded. Of its tokens nothing is known but that there are any.
class ReplayedCore : public recording::RunningCore {
  public:
    enum class Driver { itself, shared_memory };

    ReplayedCore(Machine const& machine, CoreShare share, timing::CoreTiming& timing, Driver driver)
        : machine_(machine), share_(share), timing_(timing), driver_(driver) {}

    Machine const& machine() const override { return machine_; }
    CoreShare share() const override { return share_; }
    timing::CoreTiming& timing() override { return timing_; }
    void catch_up() override {
        if (driver_ == Driver::itself)
            timing_.resolve();
    }
    std::vector<TokenField> token_fields(std::size_t) const override { return {}; }
    void add_tap(std::size_t, recording::TokenTap&) override {}
    void remove_tap(std::size_t, recording::TokenTap&) override {}

  private:
    Machine const& machine_;
    CoreShare share_;
    timing::CoreTiming& timing_;
    Driver driver_;
};

/// A sample that is wanted, and its place among them.
struct Wanted {
    std::size_t i = 0;
    SampleStatistics const* sample = nullptr;
};

/// Records samples of one core while it is replayed.
class CoreRecording {
  public:
    CoreRecording(Machine const& machine, CoreShare share, timing::CoreTiming& timing, ReplayedCore::Driver driver,
                  std::vector<Wanted> const& wanted)
        : core_(machine, share, timing, driver), wanted_(wanted) {
        for (Wanted const& one : wanted) {
            recording::RecordingWindow window;
            window.from = one.sample->start_cycle;
            window.to = one.sample->end_cycle;
            recorders_.push_back(std::make_unique<recording::CoreRecorder>(core_, window));
            recorders_.back()->before_start();
        }
    }

    /// False: all is recorded.
    bool sample_begins(std::size_t i) {
        bool records = false;
        for (auto const& recorder : recorders_) {
            recorder->sample_begins(i);
            records = records || recorder->records();
        }
        return records;
    }

    void finish(TakeTimeline const& take) {
        core_.catch_up();
        for (std::size_t k = 0; k < wanted_.size(); ++k) {
            recorders_[k]->finish();
            recording::RecordedCore recorded = recorders_[k]->recorded();
            recorded.core = wanted_[k].sample->core;
            take(wanted_[k].i, recording::sample_timeline(recorded, wanted_[k].sample->sample));
        }
    }

  private:
    ReplayedCore core_;
    std::vector<Wanted> const& wanted_;
    std::vector<std::unique_ptr<recording::CoreRecorder>> recorders_;
};

using WantedOfCore = std::map<std::size_t, std::vector<Wanted>>;

/// Samples that are recorded at once. Every operation is kept for each, until its sample has begun.
std::vector<WantedOfCore> passes_of(std::vector<SampleStatistics> const& samples) {
    constexpr std::size_t at_once = 16;
    std::vector<WantedOfCore> passes;
    std::map<std::size_t, std::size_t> number;  // of samples, by core
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::size_t const pass = number[samples[i].core]++ / at_once;
        passes.resize(std::max(passes.size(), pass + 1));
        passes[pass][samples[i].core].push_back({i, &samples[i]});
    }
    return passes;
}

/// A core whose memory is ideal needs no other.
void replay_core(replay::RecordedRun const& run, Machine const& machine, std::size_t number,
                 std::vector<Wanted> const& wanted, TakeTimeline const& take) {
    CoreShare const share = share_of(number, machine.cores, run.samples());
    std::unique_ptr<timing::PhraseCore> const core = replay::core_variant(*run.blueprint, machine);
    core->let_follow(run.lead, timing::make_answers());
    replay::PlainReader reader(run);
    CoreRecording recording(machine, share, *core, ReplayedCore::Driver::itself, wanted);
    for (std::size_t i = 0; i < share.count && recording.sample_begins(i); ++i) {
        replay::SampleOperations const operations = reader.read(share.first + i);
        for (std::size_t process = 0; process < operations.size(); ++process)
            replay::tell_sample(operations[process], core->process(process));
    }
    recording.finish(take);
}

/// Records some of the cores that share a memory.
class SharedRecording : public replay::CoreWatch {
  public:
    SharedRecording(Machine const& machine, std::size_t samples, WantedOfCore const& wanted, TakeTimeline const& take)
        : machine_(machine), samples_(samples), wanted_(wanted), take_(take) {}

    void start(std::size_t core, timing::CoreTiming& timing) override {
        if (auto const wanted = wanted_.find(core); wanted != wanted_.end())
            recordings_.emplace(std::piecewise_construct, std::forward_as_tuple(core),
                                std::forward_as_tuple(machine_, share_of(core, machine_.cores, samples_), timing,
                                                      ReplayedCore::Driver::shared_memory, wanted->second));
    }
    bool sample_begins(std::size_t core, std::size_t i) override {
        auto const recording = recordings_.find(core);
        if (recording == recordings_.end() || recording->second.sample_begins(i))
            return true;
        recording->second.finish(take_);
        recordings_.erase(recording);
        return !recordings_.empty();
    }
    void end() override {
        for (auto& [core, recording] : recordings_)
            recording.finish(take_);
    }

  private:
    Machine const& machine_;
    std::size_t samples_;
    WantedOfCore const& wanted_;
    std::map<std::size_t, CoreRecording> recordings_;
    TakeTimeline const& take_;
};

void replay_alone(replay::RecordedRun const& run, Machine const& machine, WantedOfCore const& wanted,
                  TakeTimeline const& take) {
    std::vector<WantedOfCore::value_type const*> cores;
    for (auto const& one : wanted)
        cores.push_back(&one);
    on_threads(cores.size(), jobs_or_host_cores(0),
               [&](std::size_t k) { replay_core(run, machine, cores[k]->first, cores[k]->second, take); });
}

void replay_together(replay::ScriptedRun const& run, Machine const& machine, WantedOfCore const& wanted,
                     TakeTimeline const& take) {
    SharedRecording recording(machine, run.run().samples(), wanted, take);
    replay::retime_together(run, machine, false, &recording);
}

}  // namespace

void replay_timelines(replay::ScriptedRun const& run, Machine const& machine,
                      std::vector<SampleStatistics> const& samples, TakeTimeline const& take) {
    for (WantedOfCore const& wanted : passes_of(samples))
        run.run().memory ? replay_together(run, machine, wanted, take) : replay_alone(run.run(), machine, wanted, take);
}

void replay_timelines(replay::RecordedRun const& run, Machine const& machine,
                      std::vector<SampleStatistics> const& samples, TakeTimeline const& take) {
    if (run.memory)
        return replay_timelines(replay::ScriptedRun(run), machine, samples, take);
    for (WantedOfCore const& wanted : passes_of(samples))
        replay_alone(run, machine, wanted, take);
}

SampleTimeline replayed_timeline(replay::ScriptedRun const& run, Machine const& machine,
                                 SampleStatistics const& sample) {
    SampleTimeline timeline;
    replay_timelines(run, machine, {sample},
                     [&timeline](std::size_t, SampleTimeline made) { timeline = std::move(made); });
    return timeline;
}

SampleTimeline cut(SampleTimeline timeline, Cycles from, Cycles to) {
    timeline.begin = std::max(timeline.begin, from);
    timeline.end = std::max(std::min(timeline.end, to), timeline.begin + 1);
    auto const is_outside = [&](TimelineSpan const& span) {
        return span.end <= timeline.begin || span.begin >= timeline.end;
    };
    timeline.spans.erase(std::remove_if(timeline.spans.begin(), timeline.spans.end(), is_outside),
                         timeline.spans.end());
    return timeline;
}

}  // namespace dataflow::explore
