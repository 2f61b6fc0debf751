#include "kernel/recording/core_recorder.hpp"

#include <algorithm>

namespace faster::recording {

namespace {
Cycles latest_of(timing::CoreTiming const& timing) {
    Cycles latest = 0;
    for (timing::ProcessTiming const& process : timing.processes())
        latest = std::max(latest, process.local_time());
    return latest;
}
Cycles earliest_of(timing::CoreTiming const& timing) {
    Cycles earliest = ~Cycles{0};
    for (timing::ProcessTiming const& process : timing.processes())
        earliest = std::min(earliest, process.local_time());
    return earliest;
}
auto const& stamps_of(timing::CoreTiming const& timing, ModuleId module) {
    return timing.processes()[index_of(module)].stamps();
}
}  // namespace

CoreRecorder::CoreRecorder(RasterCore& core, RecordingWindow const& window) : core_(core) {
    CoreShare const share = core.share();
    if (window.samples) {
        std::size_t const first = std::max(window.samples->first, share.first);
        std::size_t const end = std::min(window.samples->last + 1, share.first + share.count);
        if (first >= end)
            phase_ = Phase::done;
        else
            samples_ = RecordingWindow::Samples{first - share.first, end - 1 - share.first};
    } else {
        from_ = window.from;
        to_ = window.to;
    }
    if (phase_ == Phase::done)
        return;
    std::vector<FifoChannel*> const channels = core.channels();
    for (FifoChannel const* channel : channels)
        taps_.emplace_back(channel->token_fields());
    for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i]->taps().push_back(&taps_[i]);
}

void CoreRecorder::tape_to(Tape* tape) {
    for (std::size_t i = 0; i < core_.timing().processes().size(); ++i) {
        timing::ProcessTiming& process = core_.timing().process(i);
        if (taped_to_ != nullptr)
            process.remove_tape((*taped_to_)[i]);
        if (tape != nullptr)
            process.add_tape((*tape)[i]);
    }
    taped_to_ = tape;
}

void CoreRecorder::before_start() { make_checkpoint(); }

void CoreRecorder::sample_begins(std::size_t i) {
    if (phase_ == Phase::done)
        return;
    if (phase_ == Phase::recording) {
        feed();
        return;
    }
    core_.catch_up();
    learn_window();
    make_checkpoint();
    drop_checkpoints(i);
    // Otherwise, a later begin may do as well.
    if (from_ && checkpoints_.back().latest > *from_)
        start();
}

void CoreRecorder::make_checkpoint() {
    Checkpoint checkpoint;
    checkpoint.timing = core_.timing().copy();
    checkpoint.latest = latest_of(*checkpoint.timing);
    checkpoint.tape.resize(core_.timing().processes().size());
    checkpoints_.push_back(std::move(checkpoint));
    tape_to(&checkpoints_.back().tape);
}

void CoreRecorder::drop_checkpoints(std::size_t i) {
    if (from_)
        while (checkpoints_.size() > 1 && checkpoints_[1].latest <= *from_)
            checkpoints_.pop_front();
    else if (i + longest_lead() <= samples_->first)
        while (checkpoints_.size() > 1)
            checkpoints_.pop_front();
    for (std::size_t f = 0; f < taps_.size(); ++f)
        taps_[f].forget_before(std::max(checkpoints_.front().timing->fifos()[f].reads(), tokens_in_use()) -
                               tokens_in_use());
}

/// Samples by which the rasterizer can be ahead of the last process, and one: all get their headers in one step, and
/// the observation reader's tokens keep it near the inlier unit. Where a sample may have none, its valid depths keep it
/// near the result collector.
std::size_t CoreRecorder::longest_lead() const {
    auto const& fifos = core_.timing().fifos();
    std::uint64_t const headers = fifos[index_of(FifoId::sample_observation)].shape().capacity;
    if (core_.parts().sweep_region == SweepRegion::touched)
        return headers + fifos[index_of(FifoId::valid_depth)].shape().capacity + 4;
    std::uint64_t const observed = fifos[index_of(FifoId::observed_depth)].shape().capacity / core_.window_tokens();
    return headers + observed + 4;
}

/// Tokens read last that still decide what a process does: one, or the two corners of a region.
std::uint64_t CoreRecorder::tokens_in_use() const { return core_.parts().sweep_region == SweepRegion::touched ? 2 : 1; }

void CoreRecorder::learn_window() {
    if (!samples_)
        return;
    auto const& starts = stamps_of(core_.timing(), ModuleId::rasterizer);
    auto const& ends = stamps_of(core_.timing(), ModuleId::result_collector);
    if (!from_ && starts.size() > samples_->first)
        from_ = starts[samples_->first];
    if (!to_ && ends.size() > samples_->last)
        to_ = ends[samples_->last];
}

void CoreRecorder::start() {
    phase_ = Phase::recording;
    detail_ = std::move(checkpoints_.front().timing);
    capture_ = std::make_unique<CoreCapture>(*detail_, taps_, core_.share().first, tokens_in_use(), spools_);
    feed();
}

/// Works out in detail what has been taped.
void CoreRecorder::feed() {
    core_.catch_up();
    learn_window();
    if (to_)
        capture_->set_end(*to_);
    for (Checkpoint& checkpoint : checkpoints_)
        for (std::size_t i = 0; i < checkpoint.tape.size(); ++i) {
            timing::OperationLog& tape = checkpoint.tape[i];
            for (timing::Operation const* operation = tape.begin(); operation != tape.begin() + tape.pending();
                 ++operation)
                detail_->process(i).log().append(*operation);
            tape.clear();
        }
    while (checkpoints_.size() > 1)
        checkpoints_.pop_front();
    detail_->resolve();
    for (std::size_t f = 0; f < taps_.size(); ++f)
        taps_[f].forget_before(detail_->fifos()[f].writes());
    if (to_ && earliest_of(*detail_) > *to_)
        stop();
}

void CoreRecorder::finish() {
    if (phase_ == Phase::waiting && !checkpoints_.empty()) {
        learn_window();
        if (from_)
            start();
    } else if (phase_ == Phase::recording) {
        feed();
    }
    if (phase_ != Phase::done)
        stop();
    for (EventSpool& spool : spools_)
        spool.rewind();
}

void CoreRecorder::stop() {
    phase_ = Phase::done;
    if (taped_to_ != nullptr)
        tape_to(nullptr);
    std::vector<FifoChannel*> const channels = core_.channels();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        auto& taps = channels[i]->taps();
        taps.erase(std::find(taps.begin(), taps.end(), &taps_[i]));
    }
    checkpoints_.clear();
    capture_.reset();
    detail_.reset();
    taps_.clear();
}

}  // namespace faster::recording
