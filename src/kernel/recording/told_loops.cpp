#include "kernel/recording/told_loops.hpp"

#include <algorithm>

namespace faster::recording {

using timing::Operation;

namespace {
bool enters(Operation const& operation) { return operation.kind() == Operation::Kind::enter; }
}  // namespace

void ToldLoops::take(timing::OperationLog const& told) {
    std::for_each(told.begin(), told.begin() + told.pending(), [this](Operation const& operation) {
        if (enters(operation))
            at_entries_.push_back(iterations_);
        iterations_ += operation.iterations();
    });
}

/// Loops that it has told of and not entered yet are in its log.
std::uint64_t ToldLoops::done_in_loop(timing::ProcessTiming const& process) {
    timing::OperationLog const& log = process.log();
    auto const to_come = static_cast<std::size_t>(std::count_if(log.begin(), log.begin() + log.pending(), enters));
    while (at_entries_.size() > to_come + 1)
        at_entries_.pop_front();
    return at_entries_.size() > to_come ? process.all_iterations() - at_entries_.front() : 0;
}

}  // namespace faster::recording
