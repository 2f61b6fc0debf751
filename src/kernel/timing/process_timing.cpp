#include "kernel/timing/process_timing.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "kernel/base/each_bit.hpp"

namespace faster::timing {

namespace {
unsigned lowest_bit(std::uint32_t mask) { return static_cast<unsigned>(__builtin_ctz(mask)); }
}  // namespace

unsigned ProcessTiming::add_port(FifoTiming& fifo, bool writes) {
    if (ports_.size() == max_ports)
        throw std::logic_error(name_ + ": a process has at most 8 ports");
    ports_.push_back({&fifo, writes});
    return static_cast<unsigned>(ports_.size() - 1);
}

unsigned ProcessTiming::add_reads(FifoTiming& fifo) { return add_port(fifo, false); }
unsigned ProcessTiming::add_writes(FifoTiming& fifo) { return add_port(fifo, true); }

unsigned ProcessTiming::add_loop(LoopShape shape) {
    LoopPlan plan;
    plan.ii = shape.interval.achieved;
    Cycles shortest = shape.writes.empty() ? 0 : shape.writes.front().write_latency;
    for (LoopWrite const& write : shape.writes)
        shortest = std::min(shortest, write.write_latency);
    std::map<Cycles, Phase> phases;
    std::vector<LoopWrite> accesses = shape.writes;
    for (unsigned const port : shape.reads) {
        shortest = 0;
        plan.aligned = false;  // never all in one direction
        accesses.push_back({port, 0});
    }
    for (LoopWrite const& write : accesses) {
        Cycles const behind = write.write_latency - shortest;
        plan.aligned = plan.aligned && behind == 0;
        plan.longest_lag = std::max(plan.longest_lag, behind / plan.ii);
        Phase& phase = phases[behind % plan.ii];
        phase.offset = behind % plan.ii;
        phase.ports.emplace_back(write.port, behind / plan.ii);
    }
    for (auto& phase : phases)
        plan.phases.push_back(std::move(phase.second));
    plan.fill = shortest;
    plan.drain = static_cast<std::int64_t>(shape.depth) - static_cast<std::int64_t>(plan.ii + shortest);
    plan.counting = iterations_that_count(shape);
    plan.delay_line.assign(plan.longest_lag + 1, 0);
    plans_.push_back(std::move(plan));
    loops_.push_back(std::move(shape));
    loop_counters_.emplace_back();
    loop_sites_.emplace_back();
    return static_cast<unsigned>(loops_.size() - 1);
}

ProcessTiming::Status ProcessTiming::front() {
    if (front_ports_ == 0 && !find_step())
        return Status::exhausted;
    for (std::uint32_t mask = front_ports_; mask != 0; mask &= mask - 1) {
        Port const& port = ports_[lowest_bit(mask)];
        if ((port.writes ? port.fifo->known_writes() : port.fifo->known_reads()) == 0) {
            blocking_port_ = lowest_bit(mask);
            return Status::blocked;
        }
    }
    return Status::ready;
}

Cycles ProcessTiming::front_cycle() const {
    Cycles cycle = time_;
    for_each_bit(front_ports_, [&](unsigned number) {
        Port const& port = ports_[number];
        cycle = std::max(cycle, port.writes ? port.fifo->earliest_write() : port.fifo->earliest_read());
    });
    return cycle;
}

/// Waits for each access in program order, charging what each adds, then lets them happen together.
void ProcessTiming::perform(std::uint8_t ports) {
    Cycles const arrival = time_;
    int waited_for = -1;
    for_each_bit(ports, [this, &waited_for](unsigned number) {
        Port const& port = ports_[number];
        Cycles const earliest = port.writes ? port.fifo->earliest_write() : port.fifo->earliest_read();
        if (earliest <= time_)
            return;
        Cycles const stall = earliest - time_;
        time_ = earliest;
        waited_for = static_cast<int>(number);
        if (port.writes) {
            port.fifo->add_full_stall(stall);
            full_stall_cycles_ += stall;
        } else {
            port.fifo->add_empty_stall(stall);
            empty_stall_cycles_ += stall;
        }
        if (observer_ != nullptr)
            observer_->stalled(*this, number, earliest - stall, earliest);
    });
    if (trail_ != nullptr && waited_for >= 0)
        leave_trail(static_cast<unsigned>(waited_for));
    if (observer_ != nullptr)
        observer_->accessed(*this, ports, time_);
    if (!has_accessed_)
        note_first_access(ports, arrival);
    for_each_bit(ports, [this](unsigned number) {
        Port const& port = ports_[number];
        if (port.writes)
            port.fifo->write(time_);
        else
            port.fifo->read(time_);
    });
}

void ProcessTiming::leave_trail(unsigned port) {
    Region region;
    if (in_loop_) {
        bool const drains = !log_.exhausted() && log_.front().kind() == Operation::Kind::leave;
        region = Region::of_loop(current_loop_, drains ? Region::Part::drain : Region::Part::iterations);
    }
    trail_->stalled(index_, port, region, in_loop_ ? pipeline_.offset : 0, time_);
}

void ProcessTiming::set_up() {
    mark(Region::setup(), time_);
    time_ += setup_cycles_ * log_.front().count();
    mark(Region(), time_);
}

void ProcessTiming::prepare(Operation const& operation) {
    if (operation.gap() == Operation::setup_begin)
        setups_done_.push_back(time_ + setup_cycles_);
    else if (operation.gap() == Operation::setup_end)
        await_setup();
    else
        set_up();
}

void ProcessTiming::await_setup() {
    Cycles const done = setups_done_.front();
    setups_done_.pop_front();
    if (done <= time_)
        return;
    mark(Region::setup(), time_);
    awaited_setup_cycles_ += done - time_;
    time_ = done;
    mark(Region::of_loop(current_loop_, Region::Part::iterations), time_);
}

void ProcessTiming::note_first_access(std::uint8_t ports, Cycles arrival) {
    has_accessed_ = true;
    by_steps_ = observer_ != nullptr;
    first_port_ = lowest_bit(ports);
    idle_before_cycles_ = arrival == 0 ? time_ : 0;
}

void ProcessTiming::commit_front() {
    charged_until_ = never;
    perform(front_ports_);
    front_ports_ = 0;
    Operation& operation = log_.front();
    if (operation.kind() == Operation::Kind::step) {
        time_ += operation.count();
        log_.consume();
    } else if (plan().aligned) {
        if (observer_ != nullptr)
            observer_->iterated(*this, time_, iterations_, 1U + operation.gap(), plan().ii);
        time_ += plan().ii * (1U + operation.gap());
        end_iterations(operation, 1);
    } else {
        ++pipeline_.phase;
    }
}

std::uint32_t ProcessTiming::advance(bool pause) {
    std::uint32_t woken = 0;
    std::size_t const stamps = stamps_.size();
    for (;;) {
        if (!run_.active) {
            // The hot path: from one run of iterations straight to the next.
            bool const in_iterations = front_ports_ == 0 && !by_steps_ && skip_silent_iterations();
            if (!in_iterations) {
                if (front() != Status::ready || (pause && stamps_.size() > stamps))
                    return woken;
                Operation const& operation = log_.front();
                if (operation.kind() != Operation::Kind::iterate || !plan().aligned || by_steps_) {
                    for_each_bit(front_ports_, [&](unsigned port) { woken |= ports_[port].neighbour; });
                    commit_front();
                    continue;
                }
            }
            start_run(log_.whole_front());
        }
        std::uint64_t const before = iterations_;
        bool const is_over = continue_run();
        if (iterations_ != before)
            woken |= run_.ports->neighbours;
        if (!is_over)
            return woken;
    }
}

/// True if the log goes on with iterations of an aligned loop that access something; silent ones before them are
/// passed.
bool ProcessTiming::skip_silent_iterations() {
    while (in_loop_ && plan().aligned && !log_.exhausted()) {
        Operation const& whole = log_.whole_front();
        if (whole.kind() == Operation::Kind::mixed ||
            (whole.kind() == Operation::Kind::flanked && whole.has_last_port_as_tail())) {
            front_ports_ = whole.ports();
            return true;
        }
        Operation& operation = log_.front();
        if (operation.kind() != Operation::Kind::iterate)
            return false;
        if (operation.ports() != 0) {
            front_ports_ = operation.ports();
            return true;
        }
        find_step_in_iterations(operation);
    }
    return false;
}

/// Moves time and log to the next step that accesses anything; false: the log is exhausted.
bool ProcessTiming::find_step() {
    while (!log_.exhausted()) {
        Operation& operation = log_.front();
        switch (operation.kind()) {
            case Operation::Kind::wait:
                if (operation.is_setup())
                    prepare(operation);
                else
                    time_ += operation.count();
                log_.consume();
                break;
            case Operation::Kind::step:
                front_ports_ = operation.ports();
                return true;
            case Operation::Kind::enter:
                enter_loop(operation.count());
                log_.consume();
                break;
            case Operation::Kind::iterate:
                if (find_step_in_iterations(operation))
                    return true;
                break;
            case Operation::Kind::leave:
                if (find_step_while_draining())
                    return true;
                count_loop();
                in_loop_ = false;
                mark(Region(), time_);
                if (observer_ != nullptr)
                    observer_->left_loop(*this, time_);
                log_.consume();
                break;
            case Operation::Kind::stamp:
                stamps_.push_back(time_);
                if (observer_ != nullptr)
                    observer_->stamped(*this, time_);
                log_.consume();
                break;
            case Operation::Kind::mixed:
            case Operation::Kind::flanked:
                break;  // front() has split it
        }
    }
    return false;
}

bool ProcessTiming::find_step_in_iterations(Operation& operation) {
    if (plan().aligned) {
        if (operation.ports() != 0) {
            front_ports_ = operation.ports();
            return true;
        }
        std::uint64_t const count = std::uint64_t{operation.count()} * (1U + operation.gap());
        if (observer_ != nullptr)
            observer_->iterated(*this, time_, iterations_, count, plan().ii);
        time_ += plan().ii * count;
        end_iterations(operation, operation.count());
        return false;
    }
    if (find_step_in_pipeline(pipeline_.gap_left > 0 ? std::uint8_t{0} : operation.ports()))
        return true;
    // An iteration ended: one of those with accesses, or one of the `gap` that follow it.
    pipeline_.gap_left = pipeline_.gap_left > 0 ? pipeline_.gap_left - 1 : operation.gap();
    count_iterations(1);
    if (pipeline_.gap_left > 0)
        return false;
    pipeline_run_ += operation.count() == 1 ? 1U : 0U;
    take_off(operation, 1);
    return false;
}

void ProcessTiming::enter_loop(unsigned loop) {
    current_loop_ = loop;
    in_loop_ = true;
    ++loops_entered_;
    iterations_ = 0;
    if (observer_ != nullptr)
        observer_->entered_loop(*this, loop, time_);
    if (plan().fill > 0)
        mark(Region::of_loop(loop, Region::Part::fill), time_);
    time_ += plan().fill;
    mark(Region::of_loop(loop, Region::Part::iterations), time_);
    pipeline_ = PipelinePosition{};
    pipeline_.drain_left = plan().longest_lag;
    ++pipeline_run_;
}

/// From so many on, (n - 1) II + L covers n times what II is above its target: see loop_end().
std::uint64_t ProcessTiming::iterations_that_count(LoopShape const& loop) {
    InitiationInterval const& interval = loop.interval;
    Cycles const above_target = interval.recurrence_per_iteration + interval.port_conflict_per_iteration;
    if (loop.depth >= interval.achieved || above_target == 0)
        return 1;
    Cycles const target = interval.achieved - above_target;
    return std::max<std::uint64_t>(1, (interval.achieved - loop.depth + target - 1) / target);
}

void ProcessTiming::count_loop() {
    LoopEnd const end = loop_end(loops_[current_loop_], iterations_);
    LoopCounters& counters = loop_counters_[current_loop_];
    counters.entries += end.entries;
    counters.recurrence_beyond_end += end.recurrence_beyond_end;
    counters.port_conflict_beyond_end += end.port_conflict_beyond_end;
}

/// A loop shorter than its II (L < II) ends before its last iteration's II gap does: the buckets of the process stop
/// there.
LoopEnd loop_end(LoopShape const& loop, std::uint64_t iterations) {
    LoopEnd end;
    end.entries = iterations > 0 ? 1 : 0;
    if (loop.depth >= loop.interval.achieved)
        return end;
    Cycles const unstalled = (iterations - 1) * loop.interval.achieved + loop.depth;
    Cycles const recurrence = iterations * loop.interval.recurrence_per_iteration;
    Cycles const conflicts = iterations * loop.interval.port_conflict_per_iteration;
    Cycles const counted = std::min(unstalled, recurrence);
    end.recurrence_beyond_end = recurrence - counted;
    end.port_conflict_beyond_end = conflicts - std::min(conflicts, unstalled - counted);
    return end;
}

void ProcessTiming::remove_tape(OperationLog& tape) {
    tapes_.erase(std::remove(tapes_.begin(), tapes_.end(), &tape), tapes_.end());
    is_taped_ = !tapes_.empty();
}

void ProcessTiming::take_state(ProcessTiming const& other) {
    std::vector<Port> const ports = ports_;
    StepObserver* const observer = observer_;
    Trail* const trail = trail_;
    *this = other;
    ports_ = ports;
    trail_ = trail;
    port_sets_.clear();  // they point to the other's FIFOs
    tapes_.clear();
    is_taped_ = false;
    set_observer(observer);
}

LoopCost ProcessTiming::loop_cost(unsigned loop) const {
    InitiationInterval const& interval = loops_[loop].interval;
    LoopCounters const& counters = loop_counters_[loop];
    LoopCost cost;
    cost.recurrence_cycles = counters.iterations * interval.recurrence_per_iteration - counters.recurrence_beyond_end;
    cost.port_conflict_cycles =
        counters.iterations * interval.port_conflict_per_iteration - counters.port_conflict_beyond_end;
    Cycles const depth = loops_[loop].depth;
    cost.fill_drain_cycles = depth > interval.achieved ? counters.entries * (depth - interval.achieved) : 0;
    return cost;
}

std::string ProcessTiming::position() const {
    if (!in_loop_)
        return "between loops";
    return "loop " + loops_[current_loop_].name + ", iteration " + std::to_string(iterations_);
}

}  // namespace faster::timing
