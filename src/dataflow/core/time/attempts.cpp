#include <algorithm>

#include "dataflow/core/time/process_timing.hpp"

namespace dataflow::timing {

namespace {
bool is(Operation const& operation, Operation::WaitFor choice) {
    return operation.is_choice() && operation.gap() == choice;
}
}  // namespace

// What a process says that makes attempts (docs/timing-model.md#non-blocking-accesses). Their outcomes are told: here
// they get their cycles, and whatever would have come out otherwise in those is noted.

bool ProcessTiming::choose(Operation const& operation) {
    makes_attempts_ = by_steps_ = true;
    switch (operation.gap()) {
        case Operation::ports_of_window:
            return add_ports(operation.ports());
        case Operation::step_to_reach:
            return reach_step(operation.step(), operation.stops_before());
        case Operation::end_of_window:
            return end_window();
        default:
            return attempt(operation);
    }
}

/// What is told of the step at hand, behind an attempt there, is done at once.
bool ProcessTiming::add_ports(Ports::Number ports) {
    PipelinePosition const& pipeline = state_.pipeline;
    if (!pipeline.open) {
        open_iteration(ports, true);
        return true;
    }
    Cycles const next = pipeline.phase < plan_->phases.size() ? plan_->phases[pipeline.phase].offset : plan_->ii;
    Ports const before(state_.delayed(0));
    Ports late;
    Ports(ports).each([&](unsigned port) {
        Cycles const step = plan_->step_of(port).value_or(0);
        if (before.has(port) || step >= next)
            return;
        late = late | Ports::of(port);
        if (step < pipeline.offset)
            deviates(port, state_.time);
    });
    if (!late.is_empty() && !perform(late.number()))
        return false;
    state_.delayed(0) = (before | Ports(ports)).number();
    return true;
}

/// To the step, without what may be told of it yet.
bool ProcessTiming::reach_step(Cycles step, bool stops_before) {
    PipelinePosition& pipeline = state_.pipeline;
    open_window();
    if (!pass_phases_to(stops_before && step > 0 ? step - 1 : step))
        return false;
    if (step > pipeline.offset)
        pass(step - pipeline.offset);
    pipeline.offset = std::max(step, pipeline.offset);
    return true;
}

/// Behind the last iteration: only what those before it have left to do.
void ProcessTiming::open_window() {
    if (state_.pipeline.open)
        return;
    if (state_.pipeline.drain_left == plan_->longest_lag)
        mark_loop(Region::Part::drain);
    open_iteration(0, false);
}

/// With a longer II than when it was told, a loop has fewer windows left.
bool ProcessTiming::end_window() {
    if (state_.pipeline.drain_left == 0 && !state_.pipeline.open)
        return true;
    open_window();
    if (!pass_phases(0, false))
        return false;
    state_.pipeline.drain_left -= std::min<std::uint64_t>(state_.pipeline.drain_left, 1);
    return true;
}

bool ProcessTiming::attempt(Operation const& operation) {
    unsigned const number = Ports(operation.ports()).first();
    ProcessPort const& port = ports_[number];
    if (in_loop() && !reach_attempt(number, operation.iterations_behind()))
        return false;
    bool const is_known = port.end.known() > 0;
    if (operation.succeeded() && !is_known) {
        wait_for(port);
        return false;
    }
    if (is_known && (port.end.earliest() <= state_.time) != operation.succeeded())
        deviates(number, state_.time);
    if (!operation.succeeded()) {
        figures_.failed_before.resize(ports_.size());
        figures_.failed_before[number] = state_.time + 1;
    } else if (!operation.only_asked()) {
        state_.time = std::max(state_.time, port.end.earliest());
        performs(operation.ports(), state_.time);
        port.end.access(state_.time);
        note(port, 1);
    }
    return true;
}

/// The step of a port, in an iteration so many after the one that makes the attempt.
bool ProcessTiming::reach_attempt(unsigned port, std::uint64_t behind) {
    std::optional<Cycles> const offset = offset_in_window(port, behind);
    if (!offset || (state_.pipeline.open && *offset < state_.pipeline.offset)) {
        deviates(port, state_.time);
        return true;
    }
    return reach_step(*offset, false);
}

/// Nothing if the step is in another window than when it was told.
std::optional<Cycles> ProcessTiming::offset_in_window(unsigned port, std::uint64_t behind) const {
    std::optional<Cycles> const step = plan_->step_of(port);
    if (!step || *step / plan_->ii != behind)
        return std::nullopt;
    return *step % plan_->ii;
}

/// Of a process that is stuck: an attempt told behind what it waits for, which may come before that here, and let
/// others go on.
std::optional<unsigned> ProcessTiming::attempt_to_come() const {
    Operation const* const first = log_.begin();
    bool is_in_window = true;  // at hand
    for (Operation const* at = first; at != first + log_.pending() && at->kind() != Operation::Kind::leave; ++at) {
        is_in_window = is_in_window && at->iterations() == 0 && !is(*at, Operation::end_of_window);
        if (!is(*at, Operation::attempt) || (at != first && !in_loop()))
            continue;
        unsigned const port = Ports(at->ports()).first();
        std::optional<Cycles> const offset = in_loop() ? offset_in_window(port, at->iterations_behind()) : std::nullopt;
        if (!offset || at == first || (is_in_window && *offset <= offset_awaited()))
            return port;
    }
    return std::nullopt;
}

/// Of the window at hand, the step that the process cannot do.
Cycles ProcessTiming::offset_awaited() const {
    PipelinePosition const& pipeline = state_.pipeline;
    return pipeline.phase < plan_->phases.size() ? plan_->phases[pipeline.phase].offset : pipeline.offset;
}

/// What attempts did not find must not have been there.
void ProcessTiming::check_failures(Ports::Number ports) {
    Ports(ports).each([this](unsigned port) {
        if (port >= figures_.failed_before.size())
            return;
        if (ports_[port].end.earliest() < figures_.failed_before[port])
            deviates(port, figures_.failed_before[port] - 1);
        figures_.failed_before[port] = 0;
    });
}

void ProcessTiming::deviates(unsigned port, Cycles cycle) {
    if (!deviation_)
        deviation_ = Deviation{port, cycle};
}

bool ProcessTiming::found_at(unsigned port) const {
    FifoTiming::End const& end = ports_[port].end;
    return end.known() > 0 && end.earliest() <= state_.time;
}

std::optional<ProcessTiming::Deviation> ProcessTiming::deviation(bool is_over) const {
    if (deviation_)
        return deviation_;
    for (unsigned port = 0; port < figures_.failed_before.size(); ++port)
        if (ports_[port].end.known() > 0 && ports_[port].end.earliest() < figures_.failed_before[port])
            return Deviation{port, figures_.failed_before[port] - 1};
    std::optional<unsigned> const to_come = is_over ? attempt_to_come() : std::nullopt;
    return to_come ? std::optional(Deviation{*to_come, state_.time}) : std::nullopt;
}

}  // namespace dataflow::timing
