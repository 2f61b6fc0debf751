#include "dataflow/tools/recording/core_recorder.hpp"

#include <algorithm>

#include "dataflow/core/machine/core_ends.hpp"

namespace dataflow::recording {

namespace {

Cycles latest_of(timing::CoreTiming const& timing) {
    Cycles latest = 0;
    for (timing::ProcessTiming const& process : timing.processes())
        latest = std::max(latest, process.local_time());
    return latest;
}
/// Nothing more happens before.
Cycles earliest_of(timing::CoreTiming const& timing) {
    Cycles earliest = ~Cycles{0};
    for (timing::ProcessTiming const& process : timing.processes())
        earliest = std::min(earliest, process.stamps_from());
    return earliest;
}

}  // namespace

using timing::Operation;

void ToldLoops::take(timing::OperationLog const& told, timing::ProcessShape const& shape) {
    std::for_each(told.begin(), told.begin() + told.pending(), [this, &shape](Operation const& operation) {
        if (entries_.take(operation, shape))
            at_entries_.push_back(iterations_);
        iterations_ += operation.iterations();
    });
}

/// Loops that it has told of and not entered yet are in its log.
std::uint64_t ToldLoops::done_in_loop(timing::ProcessTiming const& process) {
    timing::OperationLog const& log = process.log();
    timing::LoopEntries entries{process.current_loop(), process.rests()};
    auto const to_come = static_cast<std::size_t>(
        std::count_if(log.begin(), log.begin() + log.pending(),
                      [&](Operation const& operation) { return entries.take(operation, *process.shape()); }));
    while (at_entries_.size() > to_come + 1)
        at_entries_.pop_front();
    return at_entries_.size() > to_come ? process.all_iterations() - at_entries_.front() : 0;
}

CoreRecorder::CoreRecorder(RunningCore& core, RecordingWindow const& window) : core_(core) {
    CoreShare const share = core.share();
    if (window.samples) {
        CoreShare const wanted = window.wanted_of(share);
        std::size_t const first = wanted.first - share.first;
        if (wanted.count == 0)
            phase_ = Phase::done;
        else
            samples_ = RecordingWindow::Samples{first, first + wanted.count - 1};
    } else {
        from_ = window.from;
        to_ = window.to;
    }
    if (phase_ == Phase::done)
        return;
    core.timing().keep_logs();
    spools_.processes.resize(core.timing().processes().size());
    told_loops_.resize(spools_.processes.size());
    for (std::size_t fifo = 0; fifo < core.machine().fifos.size(); ++fifo)
        taps_.emplace_back(core.token_fields(fifo));
    for (std::size_t fifo = 0; fifo < taps_.size(); ++fifo)
        core.add_tap(fifo, taps_[fifo]);
}

void CoreRecorder::tape_to(Tape* tape) {
    for (std::size_t i = 0; i < core_.timing().processes().size(); ++i) {
        timing::ProcessTiming& process = core_.timing().process(i);
        if (taped_to_ != nullptr)
            process.remove_tape(taped_to_->logs[i]);
        if (tape != nullptr)
            process.add_tape(tape->logs[i]);
    }
    for (std::size_t i = 0; i < core_.timing().streams().size(); ++i) {
        timing::MemoryStream& stream = core_.timing().stream(i);
        if (taped_to_ != nullptr)
            stream.remove_tape(taped_to_->deliveries[i]);
        if (tape != nullptr)
            stream.add_tape(tape->deliveries[i]);
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
    if (from_ && checkpoints_.back().settled_from > *from_)
        start();
}

/// An iteration under way accesses memories in each of the cycles up to the next one. That is over, and the cycle
/// behind it.
Cycles CoreRecorder::settling_cycles() const {
    Cycles longest = 0;
    for (timing::ProcessTiming const& process : core_.timing().processes())
        for (timing::LoopShape const& loop : process.loops())
            longest = std::max(longest, loop.interval.achieved);
    return longest + 1;
}

/// Not while nobody can tell whether it is early enough: the first one will do.
bool CoreRecorder::needs_checkpoint() const {
    return from_.has_value() || core_.most_samples_ahead() != RunningCore::unknown;
}

void CoreRecorder::make_checkpoint() {
    Checkpoint checkpoint;
    checkpoint.timing = core_.timing().copy();
    for (std::size_t i = 0; i < told_loops_.size(); ++i) {
        timing::ProcessTiming& process = checkpoint.timing->process(i);
        if (taped_to_ != nullptr)
            told_loops_[i].take(taped_to_->logs[i], *process.shape());
        process.set_iterations(told_loops_[i].done_in_loop(process));
    }
    checkpoint.settled_from = taped_to_ == nullptr ? 0 : latest_of(*checkpoint.timing) + settling_cycles();
    checkpoint.tape.logs.resize(core_.timing().processes().size());
    checkpoint.tape.deliveries.resize(core_.timing().streams().size());
    checkpoints_.push_back(std::move(checkpoint));
    tape_to(&checkpoints_.back().tape);
}

void CoreRecorder::drop_checkpoints(std::size_t i) {
    if (from_)
        while (checkpoints_.size() > 1 && checkpoints_[1].settled_from <= *from_)
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
    std::vector<Cycles> const starts = dataflow::sample_begins(machine, core_.timing());
    std::vector<Cycles> const& ends = dataflow::sample_ends(machine, core_.timing());
    if (!from_ && starts.size() > samples_->first)
        from_ = starts[samples_->first];
    if (!to_ && ends.size() > samples_->last)
        to_ = ends[samples_->last];
}

/// Before the first sample wanted there are those that have begun.
Cycles CoreRecorder::earliest_from() const {
    std::vector<Cycles> const starts = dataflow::sample_begins(core_.machine(), core_.timing());
    return from_.value_or(starts.empty() ? 0 : starts.back());
}

void CoreRecorder::start() {
    phase_ = Phase::recording;
    detail_ = std::move(checkpoints_.front().timing);
    capture_ =
        std::make_unique<CoreCapture>(core_.machine(), *detail_, taps_, core_.share(), core_.tokens_in_use(), spools_);
    feed();
}

void CoreRecorder::tell_detail(Tape& tape) {
    for (std::size_t i = 0; i < tape.logs.size(); ++i) {
        timing::OperationLog& log = tape.logs[i];
        for (timing::Operation const* operation = log.begin(); operation != log.begin() + log.pending(); ++operation)
            detail_->process(i).log().append(*operation);
        log.clear();
    }
    for (std::size_t i = 0; i < tape.deliveries.size(); ++i) {
        for (timing::DeliveryTape::Delivery const& delivery : tape.deliveries[i].deliveries)
            detail_->stream(i).deliver(delivery.tokens, delivery.cycle);
        tape.deliveries[i].deliveries.clear();
    }
}

/// Works out in detail what has been taped.
void CoreRecorder::feed() {
    core_.catch_up();
    learn_window();
    if (to_)
        capture_->set_end(*to_);
    for (Checkpoint& checkpoint : checkpoints_)
        tell_detail(checkpoint.tape);
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
    spools_.each([](std::size_t /*process*/, EventSpool& spool) { spool.rewind(); });
}

void CoreRecorder::stop() {
    phase_ = Phase::done;
    if (taped_to_ != nullptr)
        tape_to(nullptr);
    for (std::size_t fifo = 0; fifo < taps_.size(); ++fifo)
        core_.remove_tap(fifo, taps_[fifo]);
    checkpoints_.clear();
    for (std::size_t i = 0; detail_ != nullptr && i < told_loops_.size(); ++i)
        detail_->process(i).tell_end();
    if (detail_ != nullptr)
        detail_->resolve();
    if (capture_ != nullptr)
        capture_->finish();
    capture_.reset();
    detail_.reset();
    taps_.clear();
}

RecordedCore CoreRecorder::recorded() {
    RecordedCore recorded;
    recorded.machine = &core_.machine();
    recorded.from = from();
    recorded.to = to();
    for (timing::FifoTiming const& fifo : core_.timing().fifos())
        recorded.fifos.push_back(fifo.shape());
    for (std::size_t fifo = 0; fifo < recorded.fifos.size(); ++fifo)
        recorded.token_layouts.push_back(core_.token_fields(fifo));
    recorded.memory_activity = [&core = core_] { return core.memory_activity(); };
    recorded.spools = &spools_;
    return recorded;
}

}  // namespace dataflow::recording
