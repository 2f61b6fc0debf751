#include "dataflow/core/time/process_timing.hpp"

#include <algorithm>
#include <numeric>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/memory/memory_stream.hpp"

namespace dataflow::timing {

ProcessTiming::ProcessTiming(std::string name, unsigned index, std::shared_ptr<ProcessShape> shape)
    : Rules(std::move(shape), index), name_(std::move(name)) {
    figures_.loops.resize(loops().size());
    notes_.resize(loops().size());
}

unsigned ProcessTiming::add_port(FifoTiming& fifo, bool writes) {
    auto const number = static_cast<unsigned>(ports_.size());
    ports_.push_back({fifo.end(writes), number, &fifo, writes});
    // Copies share the shape, which has it by then: they may be made by several threads at once.
    if (writes && shape_->flushing_stages != fifo.shape().flushing_stages && fifo.shape().flushing_stages > 0) {
        shape_->flushing_stages = fifo.shape().flushing_stages;
        shape_->flushing_port = number;
    }
    port_sites_.emplace_back();
    forget_port_sets();
    return number;
}

unsigned ProcessTiming::add_stream(MemoryStream& stream) {
    stream_ = &stream;
    stream_port_ = add_port(stream.fifo(), stream.is_write());
    return stream_port_;
}

unsigned ProcessTiming::add_loop(LoopShape shape) {
    shape_->plans.emplace_back(shape);
    shape_->sets_up_ahead = shape_->sets_up_ahead || (!shape.reads.empty() && !shape.writes.empty());
    shape_->has_interlocks = shape_->has_interlocks || !shape.interlock_spans.empty();
    shape_->loops.push_back(std::move(shape));
    figures_.loops.emplace_back();
    notes_.emplace_back();
    return static_cast<unsigned>(loops().size() - 1);
}

void ProcessTiming::set_iterations(std::uint64_t iterations) {
    for (auto& wait : state_.write_waits)
        wait.iteration += static_cast<std::int64_t>(iterations - state_.iterations);
    state_.iterations = iterations;
}

void ProcessTiming::take_back_write_waits() {
    std::vector<ProcessState<Cycles>::WriteWait>& waits = state_.write_waits;
    for (; !waits.empty() && waits.back().iteration == static_cast<std::int64_t>(state_.iterations); waits.pop_back()) {
        state_.time -= waits.back().steps;
        figures_.loops[state_.loop].interlock_cycles -= waits.back().steps;
    }
}

void ProcessTiming::set_neighbour(unsigned port, ProcessMask process_bit) {
    ports_[port].neighbour = process_bit;
    forget_port_sets();
}

bool ProcessTiming::takes_from_memory() const { return stream_ != nullptr && !stream_->is_write(); }

std::shared_ptr<ProcessShape> ProcessTiming::fed_shape() const {
    return takes_from_memory() ? std::make_shared<ProcessShape>(shape_->fed(stream_port_)) : shape_;
}

/// What comes from memory never comes earlier than what came before it.
std::uint64_t ProcessTiming::fed_iterations() const {
    std::uint64_t const alike = takes_from_memory() && trail_ == nullptr ? alike_iterations() : 0;
    if (alike == 0)
        return 0;
    FifoTiming const& fifo = stream_->fifo();
    std::uint64_t const most = std::min(alike, fifo.known_reads());
    if (most > 0 && fifo.earliest_read(most - 1) <= state_.time)
        return most;
    std::uint64_t fed = 0;
    while (fed < most && fifo.earliest_read(fed) <= state_.time + fed * plan_->ii)
        ++fed;
    return fed;
}

void ProcessTiming::take_fed(std::vector<Cycles> const& cycles) {
    if (cycles.empty())
        return;
    go_on_alike(log_.front().ports(), cycles.size());
    log_.front().subtract(static_cast<std::uint32_t>(cycles.size()));
    FifoTiming::End const end = stream_->fifo().end(false);
    for (Cycles const cycle : cycles)
        end.access(cycle);
    stream_->fifo().note(false, cycles.size());
}

/// What goes to memory waits for nobody: it only needs storage for its cycles, which wait_for() may have made.
void ProcessTiming::go_on_writing() {
    do {
        has_more_storage_ = false;
        go_on();
    } while (has_more_storage_);
}

ProcessTiming::Status ProcessTiming::front() {
    stops_ = true;
    go_on_writing();
    stops_ = false;
    return log_.exhausted() ? Status::exhausted : status_;
}

unsigned ProcessTiming::missing_port() const {
    bool const is_late = !log_.exhausted() && log_.begin()->is_choice() && log_.begin()->ports() != 0;
    if (flushes() || is_late || ports_[blocking_port_].fifo->is_stream())
        return blocking_port_;
    unsigned missing = blocking_port_;
    step_at_hand().each([&](unsigned port) {
        bool const is_nearer = writes(missing) != writes(port) ? writes(missing) : port < missing;
        if (ports_[port].end.known() == 0 && is_nearer)
            missing = port;
    });
    return missing;
}

unsigned ProcessTiming::starved_port() const {
    auto starved = static_cast<unsigned>(starving_port_);
    starving_with_.each([&](unsigned port) {
        if (ports_[port].end.known() == 0)
            starved = std::min(starved, port);
    });
    return starved;
}

Cycles ProcessTiming::front_cycle() const {
    Cycles cycle = state_.time;
    front_ports_.each([&](unsigned number) {
        if (!flushes() || number != flushing_port())
            cycle = std::max(cycle, ports_[number].end.earliest());
    });
    return flushes() ? state_.flushing.step_from(state_.time, cycle).cycle : cycle;
}

void ProcessTiming::commit_front() {
    stops_ = granted_ = true;
    take();
    stops_ = granted_ = false;
}

ProcessMask ProcessTiming::advance(bool pause) {
    woken_ = 0;
    pauses_ = pause;
    stamps_before_ = figures_.stamps.size();
    go_on_writing();
    pauses_ = false;
    return woken_;
}

void ProcessTiming::wait_for(ProcessPort const& port) {
    if (port.fifo->is_stream() && port.writes) {
        port.fifo->keep_more();
        has_more_storage_ = true;
        return;
    }
    status_ = Status::blocked;
    blocking_port_ = port.number;
    if (port.fifo->is_stream())
        stream_->comes_to_step(state_.time);
}

/// What comes from memory is waited for first; nobody waits for what goes there.
void ProcessTiming::put_in_order(PortSet& set) const {
    std::stable_partition(set.begin(), set.end(),
                          [](ProcessPort const& port) { return port.fifo->is_stream() && !port.writes; });
}

bool ProcessTiming::may_access(Ports::Number ports) {
    front_ports_ = Ports(ports);
    if (!may_go_on() || (stops_ && !granted_))
        return false;
    granted_ = false;
    return true;
}

void ProcessTiming::add_stall(ProcessPort const& port, Cycles stall) {
    port.fifo->add_stall(port.writes, stall);
    if (!figures_.has_accessed) {
        figures_.waits_before.resize(ports_.size());
        figures_.waits_before[port.number] += stall;
    }
    (port.fifo->is_stream() ? figures_.memory_stall_cycles
     : port.writes          ? figures_.full_stall_cycles
                            : figures_.empty_stall_cycles) += stall;
}

void ProcessTiming::let_bubbles_in(ProcessPort const& port, Cycles bubbles, Cycles from) {
    add_stall(port, bubbles);
    if (observer_ != nullptr)
        observer_->stalled(*this, port.number, from, state_.time);
}

void ProcessTiming::lets_out(ProcessPort const& port, Cycles due, Cycles cycle) {
    add_stall(port, cycle - due);
    if (observer_ != nullptr)
        observer_->let_out(*this, port.number, due, cycle);
}

std::vector<ProcessTiming::Flight> ProcessTiming::flights() const {
    std::vector<Flight> flights;
    Cycles time = state_.time;
    for (std::size_t i = 0; i < state_.flushing.tokens().size(); ++i) {
        auto const& token = state_.flushing.tokens()[i];
        if (i >= state_.flushing.left())
            flights.push_back({time + token.steps - token.flight, token.was_frozen});
        time += token.frozen;
    }
    return flights;
}

Cycles ProcessTiming::due(Cycles left) const {
    Cycles time = state_.time;
    for (auto const& token : state_.flushing.tokens()) {
        if (time + token.steps + token.frozen == left)
            return time + token.steps;
        time += token.frozen;
    }
    return left;
}

void ProcessTiming::charge(ProcessPort const& port, Cycles stall) {
    add_stall(port, stall);
    figures_.latest_waits[figures_.waits++ % figures_.latest_waits.size()] = {port.number, stall, state_.time};
    if (observer_ != nullptr)
        observer_->stalled(*this, port.number, state_.time - stall, state_.time);
}

Cycles ProcessTiming::waited_beyond(Cycles end, unsigned port) const {
    Cycles beyond = 0;
    for (ProcessFigures::Wait const& wait : figures_.latest_waits)
        if (wait.port == port && wait.until > end)
            beyond += std::min(wait.cycles, wait.until - end);
    return beyond;
}

void ProcessTiming::performs(Ports::Number ports, Cycles arrival) {
    if (observer_ != nullptr)
        observer_->accessed(*this, Ports(ports), state_.time);
    if (makes_attempts_)
        check_failures(ports);
    if (has_accessed())
        return;
    figures_.has_accessed = true;
    by_steps_ = observer_ != nullptr || makes_attempts_;
    bool const waits_for_memory = takes_from_memory() && !stream_->is_ideal() && Ports(ports).has(stream_port_);
    figures_.idle_before_cycles = arrival == 0 && !waits_for_memory ? state_.time : 0;
}

void ProcessTiming::tell_end(OperationLog& log) const {
    if (std::any_of(loops().begin(), loops().end(), [](LoopShape const& loop) { return loop.rewinds; }))
        log.wait(0);
}

void ProcessTiming::entered_again() {
    if (loops()[state_.loop].uses_stream)
        stream_->enters_loop(state_.time);
}

void ProcessTiming::entered() {
    ++figures_.loops_entered;
    entered_again();
    if (observer_ != nullptr)
        observer_->entered_loop(*this, state_.loop, state_.time);
}

void ProcessTiming::left() {
    if (observer_ != nullptr)
        observer_->left_loop(*this, state_.time);
}

/// At rest, the next call begins at once, so many steps before the first access of its first iteration.
void ProcessTiming::stamped() {
    Cycles const begin = state_.rests ? state_.time - plan_->fill : state_.time;
    Cycles const end = state_.rests ? state_.time + static_cast<Cycles>(plan_->drain) : state_.time;
    Cycles const time = shape_->call_start.ends_samples ? end : begin;
    Cycles const cycle = time - std::min(time, shape_->stamps_back);
    figures_.stamps.push_back(cycle);
    if (shape_->call_start.ends_samples)
        figures_.next_calls.push_back(begin + (state_.rests ? 0 : 1 - shape_->stamps_back));
    if (observer_ != nullptr)
        observer_->stamped(*this, cycle);
}

void ProcessTiming::count_end() {
    LoopEnd const end = loop_end(loops()[state_.loop], state_.iterations);
    LoopCounters& counters = figures_.loops[state_.loop];
    counters.entries += end.entries;
    counters.recurrence_beyond_end += end.recurrence_beyond_end;
    counters.port_conflict_beyond_end += end.port_conflict_beyond_end;
}

void ProcessTiming::remove_tape(OperationLog& tape) {
    tapes_.erase(std::remove(tapes_.begin(), tapes_.end(), &tape), tapes_.end());
    is_taped_ = !tapes_.empty();
}

void ProcessTiming::take_state(ProcessTiming const& other) {
    state_ = other.state_;
    if (in_loop())
        be_in_loop(state_.loop + 1);
    log_ = other.log_;
    figures_ = other.figures_;
    port_sites_ = other.port_sites_;
    notes_ = other.notes_;
    arrival_ = other.arrival_;
    charged_until_ = other.charged_until_;
    starving_port_ = other.starving_port_;
    starving_site_ = other.starving_site_;
    starving_with_ = other.starving_with_;
    makes_attempts_ = other.makes_attempts_;
    set_observer(observer_);
}

std::uint64_t ProcessTiming::all_iterations() const {
    return std::accumulate(figures_.loops.begin(), figures_.loops.end(), std::uint64_t{0},
                           [](std::uint64_t sum, LoopCounters const& loop) { return sum + loop.iterations; });
}

LoopCost ProcessTiming::loop_cost(unsigned loop) const {
    InitiationInterval const& interval = loops()[loop].interval;
    LoopCounters const& counters = figures_.loops[loop];
    LoopCost cost;
    cost.recurrence_cycles = counters.iterations * interval.recurrence_per_iteration - counters.recurrence_beyond_end +
                             counters.interlock_cycles;
    cost.port_conflict_cycles =
        counters.iterations * interval.port_conflict_per_iteration - counters.port_conflict_beyond_end;
    LoopShape const& shape = loops()[loop];
    Cycles const of_pipeline = shape.depth > interval.achieved ? shape.depth - interval.achieved : 0;
    cost.fill_drain_cycles = counters.entries * (shape.entry_states + of_pipeline + shape.exit_states);
    return cost;
}

SourceSite ProcessTiming::site_at_hand(unsigned port) const {
    auto const pending =
        std::count_if(log_.begin(), log_.begin() + log_.pending(), [this, port](Operation const& told) {
            return in_loop() ? told.kind() == Kind::enter && told.count() == state_.loop
                             : told.kind() == Kind::step && Ports(told.ports()).has(port);
        });
    if (in_loop())
        return notes_[state_.loop].sites.of(static_cast<std::uint64_t>(pending) + 1);
    bool const is_flushed = flushes() && port == shape_->flushing_port;
    if (log_.exhausted() && !is_flushed)
        return starving_site_;
    std::uint64_t const inside = is_flushed ? state_.flushing.tokens().size() - state_.flushing.left() : 0;
    return port_sites_[port].of(static_cast<std::uint64_t>(pending) + inside);
}

void ProcessTiming::require_first(unsigned loop, unsigned port) const {
    Cycles const first = loops()[loop].first_stage();
    Cycles const stage = fifo(port).shape().read_stage;
    if (first < stage)
        throw InputError("loop " + name() + "." + loops()[loop].name + " reads " + fifo(port).name() + " in stage " +
                         std::to_string(stage) + ", behind other accesses of an iteration (stage " +
                         std::to_string(first) + "), but its module reads it first of all, expected " +
                         "accelerator.fifos." + fifo(port).name() + ".read_stage of at most " + std::to_string(first) +
                         ", or take_later() in the module");
}

std::string ProcessTiming::position() const {
    if (!in_loop())
        return "between loops";
    return "loop " + loops()[state_.loop].name + ", iteration " + std::to_string(state_.iterations);
}

}  // namespace dataflow::timing
