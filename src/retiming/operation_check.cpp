#include "retiming/operation_check.hpp"

#include <utility>

namespace faster::retiming {

using timing::Operation;
using Kind = Operation::Kind;

bool OperationCheck::accepts(Operation const& operation) {
    if (!has_ports(operation.all_ports()))
        return false;
    if (operation.kind() == Kind::mixed)
        return accepts_mix(operation);
    bool const is_iteration = operation.kind() == Kind::iterate || operation.kind() == Kind::flanked;
    if (!is_iteration && operation.tail_ports() != 0)
        return false;
    switch (operation.kind()) {
        case Kind::wait:
            return operation.ports() == 0 && accepts_wait(operation);
        case Kind::step:
            return !in_loop && operation.ports() != 0;
        case Kind::enter:
            in_loop = !in_loop;
            return in_loop && operation.ports() == 0 && operation.count() < process_->loops().size();
        case Kind::leave:
            in_loop = !in_loop;
            return !in_loop && operation.ports() == 0;
        case Kind::iterate:
            return in_loop && operation.count() > 0;
        case Kind::flanked:
            return in_loop && operation.count() > 1 && operation.ports() != 0 && operation.tail_ports() != 0;
        case Kind::stamp:
            return operation.ports() == 0 && !std::exchange(stamped, true);
        case Kind::mixed:
            break;
    }
    return false;
}

bool OperationCheck::accepts_mix(Operation const& operation) const {
    return in_loop && operation.ports() != 0 && operation.length() > 0 &&
           operation.length() <= Operation::longest_mix &&
           (operation.gaps() & ~Operation::gap_bits(1, operation.length())) == 0;
}

/// Outside loops a process waits, or does a whole setup; in a loop it awaits what it has begun.
bool OperationCheck::accepts_wait(Operation const& operation) {
    if (operation.gap() <= Operation::whole_setup)
        return !in_loop;
    if (operation.gap() > Operation::setup_end)
        return false;
    setups += operation.gap() == Operation::setup_begin ? 1 : -1;
    return in_loop && setups >= 0;
}

bool OperationCheck::is_in_loop_at(Operation const& operation) {
    switch (operation.kind()) {
        case Kind::wait:
            return operation.gap() > Operation::whole_setup;
        case Kind::leave:
        case Kind::iterate:
        case Kind::mixed:
        case Kind::flanked:
            return true;
        default:
            return false;
    }
}

}  // namespace faster::retiming
