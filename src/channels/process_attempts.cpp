#include <algorithm>
#include <systemc>
#include <utility>

#include "channels/dataflow_core.hpp"
#include "channels/fifo_channel.hpp"
#include "channels/process_clock.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

// Non-blocking accesses. All processes of the design go in lockstep: when the SystemC kernel has got to the cycle of a
// step, everything that is done before that cycle is done, and what is done in it makes no difference.
//
// So a pipelined loop that makes attempts must not be told of steps that lie behind one of them. Iterations are looked
// at in windows, from the first step in which one accesses anything to that of the next: attempts, and what is read
// later, are made in the window in which their steps are. Only then is the iteration told that has begun there.

timing::Ports ProcessClock::write_port_of(FifoChannel const& fifo) { return fifo.write_port(); }

/// Of the loop at hand, from the first access of an iteration on.
std::uint64_t ProcessClock::step_of(unsigned port) const {
    return timing_.shape()->plans[pipelined_].step_of(port).value_or(0);
}

void ProcessClock::end_body() {
    last_attempt_.reset();
    attempted_ = timing::Ports();
    if (may_wait_ && !has_waited_)
        await_writes(pipelined_);
    has_waited_ = false;
    if (!makes_attempts_)
        iterate(std::exchange(collected_, timing::Ports()), 1);
}

/// Its window, as the next one begins in a step.
void ProcessClock::end_iteration(std::uint64_t step) {
    take_before(step);
    if (is_told_)
        tell_ports();
    iterate(std::exchange(collected_, timing::Ports()), 1);
    told_ = timing::Ports();
    is_told_ = false;
    reached_ = step;
}

void ProcessClock::drain() {
    Cycles const interval = timing_.loops()[pipelined_].interval.achieved;
    if (!has_begun_)
        return;
    end_iteration(reached_ + interval);
    is_draining_ = true;
    for (; !takings_.empty(); reached_ += interval) {
        take_before(reached_ + interval);
        say([](OperationLog& log) { log.end_window(); });
    }
    is_draining_ = false;
}

/// What the iteration at hand is known to access so far.
void ProcessClock::tell_ports() {
    if (is_draining_ || (is_told_ && told_ == collected_))
        return;
    is_told_ = true;
    told_ = collected_;
    say([this](OperationLog& log) { log.add_ports(told_.number()); });
}

// How far it is within an iteration is told to the log that gets cycles alone: no recording needs it.

/// Of the window at hand, in front of the accesses of a step, or behind all of them.
void ProcessClock::reach_step(std::uint64_t step, bool stops_before) {
    tell_ports();
    timing_.log().reach_step(step - reached_, stops_before);
    follow();
}

void ProcessClock::tell_behind_attempt(timing::Ports port) {
    std::uint64_t const step = reached_ + step_of(port.first());
    if (step < *last_attempt_ && is_memory(port.first()))
        throw InputError(
            "module " + timing_.name() +
            " accesses the memory behind an access that does not wait and that is in a later stage, expected "
            "clock_.access_memory() before it");
    if (step < *last_attempt_)
        throw InputError(
            "module " + timing_.name() + (timing_.writes(port.first()) ? " writes " : " reads ") +
            fifos_[port.first()]->timing().name() +
            " behind an access that does not wait and that is in a later stage, expected accesses in the " +
            "order of their stages: other ones by accelerator.fifos.FIFO." +
            (timing_.writes(port.first()) ? "write_latency" : "read_stage"));
    if (step == *last_attempt_)
        tell_ports();
}

void ProcessClock::require_attempts(FifoChannel const& fifo, timing::Ports port) const {
    unsigned const number = port.first();
    bool const writes = timing_.writes(number);
    std::string const what =
        "module " + timing_.name() + (writes ? " writes " : " reads ") + fifo.timing().name() + " without waiting";
    if (number >= may_attempt_.size() || !may_attempt_[number])
        throw InputError(what + ", which its describe() does not say, expected " +
                         (writes ? "writes_to(\"" : "reads_from(\"") + fifo.timing().name() + "\").non_blocking()");
    if (!is_pipelining_ && timing_.in_loop())
        throw InputError(what + " in a loop that is not run by clock_.pipeline(), expected that");
    if (is_pipelining_ && (!makes_attempts_ || !timing_.shape()->plans[pipelined_].step_of(number)))
        throw InputError(what + " in the loop " + timing_.loops()[pipelined_].name +
                         ", which does not name that FIFO, expected " +
                         (writes ? "leaves() or writes_to()" : "taken() or also_reads()"));
}

bool ProcessClock::attempts(FifoChannel const& fifo, timing::Ports port, bool only_asks) {
    require_own(fifo, timing_.writes(port.first()));
    if (is_in_tokens_body_)
        refuse_in_tokens_body(fifo.timing().name());
    require_attempts(fifo, port);
    if (!is_pipelining_) {
        if (collecting_ && !collected_.is_empty())
            step(std::exchange(collected_, timing::Ports()));
        return decide(port, only_asks, 0);
    }
    if (!collecting_)
        throw InputError("module " + timing_.name() + " accesses " + fifo.timing().name() +
                         " without waiting in what is done later in an iteration, expected it in the body");
    std::uint64_t const step = reached_ + step_of(port.first());
    Cycles const interval = timing_.loops()[pipelined_].interval.achieved;
    if (step >= reached_ + interval)
        throw InputError("module " + timing_.name() + " accesses " + fifo.timing().name() +
                         " without waiting in a stage in which the next iteration has begun to access FIFOs, " +
                         "expected a stage less than " + std::to_string(interval) +
                         " behind the first that accesses any, or try_read_later() and try_write_later()");
    if (!only_asks)
        require_once(port);
    last_attempt_ = last_attempt_ ? std::max(*last_attempt_, step) : step;
    if (step < *last_attempt_)
        tell_behind_attempt(port);
    if (!only_asks)
        attempted_ = attempted_ | port;
    take_before(step);
    reach_step(step, false);
    take_before(step + 1);
    return decide(port, only_asks, 0);
}

void ProcessClock::attempt_later(FifoChannel const& fifo, timing::Ports port,
                                 std::function<void(std::uint64_t step)> attempt) {
    require_own(fifo, timing_.writes(port.first()));
    require_attempts(fifo, port);
    if (!is_pipelining_ || !collecting_)
        throw InputError("module " + timing_.name() + " accesses " + fifo.timing().name() +
                         " later in an iteration, expected that in the body of a pipeline()");
    require_once(port);
    attempted_ = attempted_ | port;
    note_end(port);
    std::uint64_t const step = reached_ + step_of(port.first());
    put_off(
        step, [step, attempt = std::move(attempt)] { attempt(step); }, timing::no_ports);
}

/// Of an iteration whose step lies in the window at hand.
bool ProcessClock::attempts_in(timing::Ports port, std::uint64_t step) {
    reach_step(step, false);
    return decide(port, false, step_of(port.first()) / timing_.loops()[pipelined_].interval.achieved);
}

bool ProcessClock::decide(timing::Ports port, bool only_asks, std::uint64_t iterations_behind) {
    if (dataflow_core_.has_failed())
        suspend(sc_core::sc_event());  // for ever: a core of which a process has failed is not to go on by asking
    for (sc_core::sc_time left = left_until(timing_.local_time()); left > sc_core::SC_ZERO_TIME;
         left = left_until(timing_.local_time()))
        suspend(left);
    bool const found = timing_.found_at(port.first());
    say([=](OperationLog& log) {
        log.attempt(port.number(), found, only_asks, static_cast<std::uint32_t>(iterations_behind));
    });
    if (found && !only_asks) {
        FifoChannel& fifo = *fifos_[port.first()];
        timing_.writes(port.first()) ? fifo.wake_reader() : wake_writer(fifo);
    }
    return found;
}

}  // namespace dataflow
