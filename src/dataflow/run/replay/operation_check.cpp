#include "dataflow/run/replay/operation_check.hpp"

#include <algorithm>
#include <utility>

namespace dataflow::replay {

using timing::Operation;
using Kind = Operation::Kind;

bool OperationCheck::accepts(Operation const& operation) {
    if (!has_ports(operation.ports()) || !has_ports(operation.tail_ports()))
        return false;
    switch (operation.kind()) {
        case Kind::wait:
            return operation.is_choice() ? accepts_choice(operation)
                                         : operation.all_ports() == 0 && accepts_wait(operation);
        case Kind::step:
            return !state_.in_loop && operation.ports() != 0 && operation.tail_ports() == 0;
        case Kind::enter:
            state_.loop = operation.count();
            return operation.all_ports() == 0 && operation.count() < process_->loops().size() &&
                   !std::exchange(state_.in_loop, true);
        case Kind::leave:
            return operation.all_ports() == 0 && std::exchange(state_.in_loop, false);
        case Kind::iterate:
        case Kind::flanked:
            return state_.in_loop && can_iterate(operation.ports()) && can_iterate(operation.tail_ports()) &&
                   accepts_iterations(operation);
        case Kind::stamp:
            return operation.all_ports() == 0 && !std::exchange(state_.stamped, true);
        case Kind::mixed:
            return state_.in_loop && can_iterate(operation.ports()) && accepts_mix(operation);
    }
    return false;
}

bool OperationCheck::has_ports(timing::Ports::Number ports) const {
    bool has = timing::Ports::is_known(ports);
    if (has)
        timing::Ports(ports).each([&](unsigned port) { has = has && port < process_->port_count(); });
    return has;
}

/// An iteration reads or writes; both only in processes that have a loop of both.
bool OperationCheck::can_iterate(timing::Ports::Number ports) const {
    bool reads = false, writes = false;
    timing::Ports(ports).each([&](unsigned port) { (process_->writes(port) ? writes : reads) = true; });
    return process_->shape()->sets_up_ahead || !reads || !writes;
}

bool OperationCheck::accepts_iterations(Operation const& operation) const {
    bool const is_flanked = operation.kind() == Kind::flanked;
    return is_flanked ? operation.count() > 1 && operation.ports() != 0 && operation.tail_ports() != 0
                      : operation.count() > 0;
}

bool OperationCheck::accepts_mix(Operation const& operation) const {
    return operation.ports() != 0 && operation.length() > 0 && operation.length() <= Operation::longest_mix &&
           (operation.gaps() & ~Operation::gap_bits(1, operation.length())) == 0;
}

/// Outside loops a process waits, or does a whole setup; in a loop it awaits what it has begun, or a write.
bool OperationCheck::accepts_wait(Operation const& operation) {
    if (operation.awaits_write())
        return state_.in_loop && accepts_await_write(operation);
    if (operation.gap() <= Operation::whole_setup || operation.gap() == Operation::call_start)
        return !state_.in_loop;
    if (!process_->shape()->sets_up_ahead)
        return false;
    state_.setups += operation.gap() == Operation::setup_begin ? 1 : -1;
    return state_.in_loop && state_.setups >= 0;
}

/// What is between iterations of a loop that makes attempts, and attempts outside loops.
bool OperationCheck::accepts_choice(Operation const& operation) const {
    if (operation.tail_ports() != 0 || (state_.in_loop && !makes_attempts()))
        return false;
    if (operation.gap() == Operation::attempt)
        return operation.ports() != 0 &&
               timing::Ports::of(timing::Ports(operation.ports()).first()).number() == operation.ports();
    return state_.in_loop && (operation.ports() == 0 || operation.gap() == Operation::ports_of_window);
}

bool OperationCheck::makes_attempts() const {
    auto const& loops = process_->loops();
    return state_.loop < loops.size() && loops[state_.loop].makes_attempts;
}

/// In a loop that nobody knows, what any of them may say: nobody waits for what the loop has not.
bool OperationCheck::accepts_await_write(Operation const& operation) const {
    auto const& loops = process_->loops();
    auto const has = [&operation](timing::LoopShape const& loop) {
        return operation.dependence() < loop.interlock_spans.size();
    };
    bool const is_known = state_.loop < loops.size();
    return operation.count() > 0 && (is_known ? has(loops[state_.loop]) : std::any_of(loops.begin(), loops.end(), has));
}

bool OperationCheck::is_in_loop_at(Operation const& operation) {
    switch (operation.kind()) {
        case Kind::wait:
            return operation.gap() > Operation::whole_setup && operation.gap() != Operation::call_start;
        case Kind::leave:
        case Kind::iterate:
        case Kind::mixed:
        case Kind::flanked:
            return true;
        default:
            return false;
    }
}

}  // namespace dataflow::replay
