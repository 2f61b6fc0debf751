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
}  // namespace

CoreRecorder::CoreRecorder(RunningCore& core, RecordingWindow const& window) : core_(core) {
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
    spools_.resize(core.timing().processes().size());
    for (std::size_t fifo = 0; fifo < core.machine().fifos.size(); ++fifo)
        taps_.emplace_back(core.token_fields(fifo));
    for (std::size_t fifo = 0; fifo < taps_.size(); ++fifo)
        core.add_tap(fifo, taps_[fifo]);
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
    if (!needs_checkpoint())
        return;
    make_checkpoint();
    drop_checkpoints(i);
    // Otherwise, a later begin may do as well.
    if (from_ && checkpoints_.back().latest > *from_)
        start();
}

/// Not while nobody can tell whether it is early enough: the first one will do.
bool CoreRecorder::needs_checkpoint() const {
    return from_.has_value() || core_.most_samples_ahead() != RunningCore::unknown;
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
    else if (i + core_.most_samples_ahead() <= samples_->first)
        while (checkpoints_.size() > 1)
            checkpoints_.pop_front();
    for (std::size_t f = 0; f < taps_.size(); ++f)
        taps_[f].forget_before(std::max(checkpoints_.front().timing->fifos()[f].reads(), core_.tokens_in_use()) -
                               core_.tokens_in_use());
}

void CoreRecorder::learn_window() {
    if (!samples_)
        return;
    Machine const& machine = core_.machine();
    std::vector<Cycles> const& starts = core_.timing().process(machine.begins).stamps();
    std::vector<Cycles> const& ends = core_.timing().process(machine.ends).stamps();
    if (!from_ && starts.size() > samples_->first)
        from_ = starts[samples_->first];
    if (!to_ && ends.size() > samples_->last)
        to_ = ends[samples_->last];
}

void CoreRecorder::start() {
    phase_ = Phase::recording;
    detail_ = std::move(checkpoints_.front().timing);
    capture_ = std::make_unique<CoreCapture>(core_.machine(), *detail_, taps_, core_.share().first,
                                             core_.tokens_in_use(), spools_);
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
    for (std::size_t fifo = 0; fifo < taps_.size(); ++fifo)
        core_.remove_tap(fifo, taps_[fifo]);
    checkpoints_.clear();
    if (capture_ != nullptr)
        capture_->finish();
    capture_.reset();
    detail_.reset();
    taps_.clear();
}

}  // namespace faster::recording
