#include "kernel/timing/bench_process.hpp"

#include <algorithm>

namespace faster::timing {

BenchProcess::BenchProcess(ProcessTiming const& process, FigureBlock* figures, Trail* trail)
    : process_(&process), trail_(trail), log_(64) {
    for (unsigned loop = 0; loop < process.loops().size(); ++loop) {
        std::uint32_t const blocks = RelativeState::blocks_of(process.loops()[loop]);
        loops_.push_back({&process.plan(loop), &process.loops()[loop], figures, blocks});
        figures += blocks;
    }
}

StateWord const* BenchProcess::load(StateWord const* words) {
    time_ = *words++;
    ProcessFlags const flags = ProcessFlags::of(words);
    words += ProcessFlags::words;
    be_in_loop(flags.loop);
    iterations_ = flags.begun;
    outlook_ports_ = flags.next_ports;
    frozen_ = flags.frozen;
    parked_at_ = flags.waits_at - 1;
    if (in_loop_ && !plan().aligned) {
        std::uint64_t const lags = plan().longest_lag;
        pipeline_ = Pipeline{};
        pipeline_.iteration = pipeline_.drain_left = lags;
        clear_delay_line();
        for (std::uint64_t lag = 1; lag <= lags; ++lag)
            delay_line_[lags - lag] = static_cast<std::uint8_t>(*words++);
    }
    log_front_ = log_end_ = 0;
    for (std::size_t i = 0; i < flags.left; ++i, words += words_of_operation)
        append(Operation(code_of(words)));
    return words;
}

/// From 1 on; 0: in none.
void BenchProcess::be_in_loop(unsigned number) {
    in_loop_ = number != 0;
    if (in_loop_)
        loop_ = number - 1;
    early_ = in_loop_ ? std::min<std::int64_t>(plan().drain, 0) : 0;
    counting_ = in_loop_ ? plan().counting : 0;
}

/// Its size is a power of two, so that nothing need be divided.
void BenchProcess::clear_delay_line() {
    std::size_t size = 1;
    while (size <= plan().longest_lag)
        size *= 2;
    delay_line_.assign(size, 0);
}

/// To its begin, over what is done.
void BenchProcess::move_log_back() {
    std::copy(log_.data() + log_front_, log_.data() + log_end_, log_.data());
    log_end_ -= log_front_;
    log_front_ = 0;
}

StateWord* BenchProcess::save(StateWord* words, std::int64_t base) const {
    *words++ = frozen_ ? 0 : static_cast<StateWord>(time_ - base);
    ProcessFlags flags;
    flags.loop = in_loop_ ? loop_ + 1 : 0;
    flags.begun = std::min(iterations_, counting_);
    flags.next_ports = outlook_ports_;
    flags.frozen = frozen_;
    flags.waits_at = parked_at_ + 1;
    flags.left = log_end_ - log_front_;
    words = flags.put(words);
    if (in_loop_ && !plan().aligned)
        for (std::uint64_t lag = 1; lag <= plan().longest_lag; ++lag)
            *words++ = pipeline_.iteration < lag ? 0 : delayed(lag);
    for (std::size_t i = log_front_; i < log_end_; ++i)
        words = put_code(log_[i].code(), words);
    return words;
}

std::size_t BenchProcess::most_words() const {
    std::uint64_t longest_lag = 0;
    for (Loop const& loop : loops_)
        longest_lag = std::max<std::uint64_t>(longest_lag, loop.plan->longest_lag);
    return 1 + ProcessFlags::words + longest_lag;
}

void BenchProcess::leave_trail(unsigned number) {
    Region region;
    if (in_loop_) {
        bool const drains = !finished() && log_[log_front_].kind() == Kind::leave;
        region = Region::of_loop(loop_, drains ? Region::Part::drain : Region::Part::iterations);
    }
    trail_->stalled(process_->index(), number, region, in_loop_ ? pipeline_.offset : 0, static_cast<Cycles>(time_));
}

std::uint32_t BenchProcess::advance() {
    accessed_ = 0;
    while (log_front_ != log_end_ && take(log_[log_front_])) {
    }
    return accessed_;
}

/// Does what it can of an operation, the front one. Whether that is all, and the next is to be looked at.
bool BenchProcess::take(Operation& operation) {
    switch (operation.kind()) {
        case Kind::wait:
            if (operation.is_setup())
                mark(Region::setup());
            time_ +=
                static_cast<std::int64_t>(operation.count() * (operation.is_setup() ? process_->setup_cycles() : 1));
            if (operation.is_setup())
                mark(Region());
            break;
        case Kind::step:
            if (!perform(operation.ports()))
                return false;
            time_ += operation.count();
            break;
        case Kind::enter:
            enter(operation.count());
            break;
        case Kind::leave:
            if (!leave())
                return false;
            break;
        case Kind::mixed:
            return iterate_mix(operation);
        case Kind::flanked:
            split_flanked();
            return true;
        case Kind::iterate:
            return plan().aligned ? iterate(operation) : iterate_in_pipeline(operation);
        case Kind::stamp:
            break;  // in no phrase
    }
    ++log_front_;
    return true;
}

/// All accesses of a step together, if they are known: waits for each in program order.
bool BenchProcess::perform(std::uint8_t ports) {
    for (std::uint32_t mask = ports; mask != 0; mask &= mask - 1) {
        Port const& port = ports_[static_cast<unsigned>(__builtin_ctz(mask))];
        blocked_at_ = port.fifo;
        if (port.consumes->known() == 0)
            return false;
    }
    unsigned waited_at = no_port;
    for_each_bit(ports, [&](unsigned number) {
        std::int64_t const before = time_;
        wait(number, *ports_[number].consumes->cycles());
        waited_at = time_ > before ? number : waited_at;
    });
    if (trail_ != nullptr && waited_at != no_port)
        leave_trail(waited_at);
    for_each_bit(ports, [&](unsigned number) {
        Port& port = ports_[number];
        port.consumes->consume(1);
        port.appends->reserve(1);
        *port.appends->end() = static_cast<BenchLine::Cycle>(time_ + port.later);
        port.appends->append(1);
        accessed_ |= port.fifo;
    });
    return true;
}

void BenchProcess::enter(unsigned loop) {
    be_in_loop(loop + 1);
    entered_ = true;
    iterations_ = 0;
    if (plan().fill > 0)
        mark(Region::of_loop(loop, Region::Part::fill));
    time_ += static_cast<std::int64_t>(plan().fill);
    mark(Region::of_loop(loop, Region::Part::iterations));
    pipeline_ = Pipeline{};
    pipeline_.drain_left = plan().longest_lag;
    if (!plan().aligned)
        clear_delay_line();
}

bool BenchProcess::leave() {
    if (pipeline_.drain_left == plan().longest_lag && !pipeline_.open)
        mark(Region::of_loop(loop_, Region::Part::drain));
    for (; pipeline_.drain_left > 0; --pipeline_.drain_left)
        if (!pass_phases(0))
            return false;
    time_ += plan().drain - static_cast<std::int64_t>(plan().longest_lag * plan().ii);
    count_end(loops_[loop_]);
    be_in_loop(0);
    mark(Region());
    return true;
}

void BenchProcess::count_end(Loop const& loop) {
    counted_ |= 1U << loop_;
    LoopEnd const end = loop_end(*loop.shape, iterations_);
    loop.figures->sums[0] += static_cast<std::uint32_t>(end.entries);
    if (loop.blocks == 1)
        return;
    FigureBlock& beyond_end = loop.figures[1];
    beyond_end.sums[0] += static_cast<std::uint32_t>(end.recurrence_beyond_end);
    beyond_end.sums[1] += static_cast<std::uint32_t>(end.port_conflict_beyond_end);
}

/// An iteration with accesses, or one of the silent ones behind it.
bool BenchProcess::iterate_in_pipeline(Operation& operation) {
    if (!pass_phases(pipeline_.gap_left > 0 ? std::uint8_t{0} : operation.ports()))
        return false;
    pipeline_.gap_left = pipeline_.gap_left > 0 ? pipeline_.gap_left - 1 : operation.gap();
    count(1);
    if (pipeline_.gap_left == 0)
        take_off(operation, 1);
    return true;
}

/// The steps of one iteration; false: it waits in one of them.
bool BenchProcess::pass_phases(std::uint8_t ports) {
    ProcessTiming::LoopPlan const& plan = this->plan();
    if (!pipeline_.open) {
        delay_line_[pipeline_.iteration & (delay_line_.size() - 1)] = ports;
        pipeline_.open = true;
        pipeline_.phase = 0;
        pipeline_.offset = 0;
    }
    for (; pipeline_.phase < plan.phases.size(); ++pipeline_.phase) {
        ProcessTiming::Phase const& phase = plan.phases[pipeline_.phase];
        time_ += static_cast<std::int64_t>(phase.offset - pipeline_.offset);
        pipeline_.offset = phase.offset;
        std::uint32_t mask = 0;
        for (auto const& [port, lag] : phase.ports)
            if (pipeline_.iteration >= lag)
                mask |= delayed(lag) & (1U << port);
        if (mask != 0 && !perform(static_cast<std::uint8_t>(mask)))
            return false;
    }
    time_ += static_cast<std::int64_t>(plan.ii - pipeline_.offset);
    pipeline_.open = false;
    ++pipeline_.iteration;
    return true;
}

/// Only drivers have them, and nothing before them in the log is needed any more but room for one.
void BenchProcess::split_flanked() {
    Operation const flanked = log_[log_front_];
    log_[log_front_] = flanked.rest();
    if (log_front_ == 0) {
        append(flanked);
        std::copy_backward(log_.begin(), log_.begin() + static_cast<std::ptrdiff_t>(log_end_) - 1,
                           log_.begin() + static_cast<std::ptrdiff_t>(log_end_));
        log_front_ = 1;
    }
    log_[--log_front_] = flanked.head();
}

}  // namespace faster::timing
