#include "kernel/explore/replayed_timeline.hpp"

#include <algorithm>

#include "kernel/machine/core_share.hpp"
#include "kernel/recording/core_recorder.hpp"
#include "kernel/recording/core_timeline.hpp"
#include "kernel/replay/core_variant.hpp"
#include "kernel/replay/plain_reader.hpp"

namespace faster::explore {

namespace {

/// A core that does again what was recorded. Its tokens are nothing but that there are any.
class ReplayedCore : public recording::RunningCore {
  public:
    ReplayedCore(replay::RecordedRun const& run, Machine const& machine, CoreShare share)
        : machine_(machine),
          share_(share),
          timing_(replay::core_variant(*run.blueprint, machine)),
          reader_(run, run.lead(machine)),
          taps_(machine.fifos.size(), nullptr),
          shown_(machine.fifos.size(), 0) {}

    Machine const& machine() const override { return machine_; }
    CoreShare share() const override { return share_; }
    timing::CoreTiming& timing() override { return *timing_; }
    void catch_up() override {
        timing_->resolve();
        for (std::size_t fifo = 0; fifo < taps_.size(); ++fifo)
            show_tokens(fifo);
    }
    std::vector<TokenField> token_fields(std::size_t) const override { return {{"token", 1}}; }
    void add_tap(std::size_t fifo, recording::TokenTap& tap) override { taps_[fifo] = &tap; }
    void remove_tap(std::size_t fifo, recording::TokenTap&) override { taps_[fifo] = nullptr; }

    /// All that its processes do for a sample.
    void feed(std::size_t sample) {
        replay::SampleOperations const operations = reader_.read(sample);
        for (std::size_t i = 0; i < operations.size(); ++i) {
            timing::ProcessTiming& process = timing_->process(i);
            replay::append_sample(operations[i], process.log());
            for (timing::OperationLog* const tape : process.tapes())
                replay::append_sample(operations[i], *tape);
        }
    }

  private:
    void show_tokens(std::size_t fifo) {
        std::uint64_t const written = timing_->fifos()[fifo].writes();
        if (taps_[fifo] != nullptr && written > shown_[fifo])
            taps_[fifo]->room(written - shown_[fifo]);
        shown_[fifo] = written;
    }

    Machine const& machine_;
    CoreShare share_;
    std::unique_ptr<timing::CoreTiming> timing_;
    replay::PlainReader reader_;
    std::vector<recording::TokenTap*> taps_;  // by FIFO
    std::vector<std::uint64_t> shown_;
};

}  // namespace

SampleTimeline replayed_timeline(replay::RecordedRun const& run, Machine const& machine,
                                 SampleStatistics const& sample) {
    CoreShare const share = share_of(sample.core, machine.cores, run.tape.samples());
    ReplayedCore core(run, machine, share);
    recording::RecordingWindow window;
    window.from = sample.start_cycle;
    window.to = sample.end_cycle;
    recording::CoreRecorder recorder(core, window);
    recorder.before_start();
    for (std::size_t i = 0; i < share.count; ++i) {
        recorder.sample_begins(i);
        core.feed(share.first + i);
    }
    core.catch_up();
    recorder.finish();

    recording::RecordedCore recorded = recorder.recorded();
    recorded.core = sample.core;
    return recording::sample_timeline(recorded, sample.sample);
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

}  // namespace faster::explore
