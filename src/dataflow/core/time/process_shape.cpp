#include "dataflow/core/time/process_shape.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace dataflow::timing {

namespace {
std::vector<LoopAccess> accesses_of(LoopShape const& loop) {
    std::vector<LoopAccess> accesses = loop.writes;
    accesses.insert(accesses.end(), loop.reads.begin(), loop.reads.end());
    return accesses;
}
}  // namespace

Cycles LoopShape::first_stage() const {
    Cycles first = std::numeric_limits<Cycles>::max();
    for (LoopAccess const& access : accesses_of(*this))
        first = std::min(first, access.stage);
    return first;
}

LoopPlan::LoopPlan(LoopShape const& loop) : ii(loop.interval.achieved), counting(iterations_that_count(loop)) {
    std::vector<LoopAccess> const accesses = accesses_of(loop);
    Cycles const first = accesses.empty() ? 0 : loop.first_stage();
    fill = loop.entry_states + first;
    aligned = (loop.reads.empty() || loop.writes.empty()) && !loop.makes_attempts;
    std::map<Cycles, LoopPhase> phase_at;
    for (LoopAccess const& access : accesses) {
        Cycles const behind = access.stage - first;
        aligned = aligned && behind == 0;
        longest_lag = std::max(longest_lag, behind / ii);
        LoopPhase& phase = phase_at[behind % ii];
        phase.offset = behind % ii;
        phase.ports.emplace_back(access.port, behind / ii);
    }
    for (auto& phase : phase_at)
        phases.push_back(std::move(phase.second));
    drain = static_cast<std::int64_t>(loop.depth + loop.exit_states) - static_cast<std::int64_t>(ii + first);
    while (delay_line_length <= longest_lag)
        delay_line_length *= 2;
}

LoopPlan LoopPlan::in_steps() const {
    LoopPlan plan = *this;
    plan.aligned = true;
    plan.ii -= phases.back().offset;
    plan.drain -= static_cast<std::int64_t>(longest_lag * ii);
    plan.longest_lag = 0;
    return plan;
}

std::optional<Cycles> LoopPlan::step_of(unsigned port) const {
    for (LoopPhase const& phase : phases)
        for (auto const& [number, lag] : phase.ports)
            if (number == port)
                return lag * ii + phase.offset;
    return std::nullopt;
}

bool ProcessShape::goes_on_with(Operation const& operation, unsigned loop) const {
    return operation.kind() == Operation::Kind::stamp || (operation.is_call_start() && !call_start.is_in_turn) ||
           (operation.kind() == Operation::Kind::enter && operation.count() == loop);
}

bool LoopEntries::take(Operation const& operation, ProcessShape const& shape) {
    bool const enters = operation.kind() == Operation::Kind::enter;
    bool const goes_on = rests && shape.goes_on_with(operation, loop);
    rests = operation.kind() == Operation::Kind::leave ? shape.loops[loop].rewinds : goes_on && !enters;
    loop = enters ? operation.count() : loop;
    return enters && !goes_on;
}

ProcessShape ProcessShape::fed(unsigned stream_port) const {
    ProcessShape shape = *this;
    shape.plans.clear();
    for (LoopShape& loop : shape.loops) {
        auto const is_fed = [stream_port](LoopAccess const& read) { return read.port == stream_port; };
        loop.reads.erase(std::remove_if(loop.reads.begin(), loop.reads.end(), is_fed), loop.reads.end());
        loop.uses_stream = false;
        shape.plans.emplace_back(loop);
    }
    return shape;
}

/// From so many on, (n - 1) II + L covers n times what II is above its target: see loop_end().
std::uint64_t iterations_that_count(LoopShape const& loop) {
    InitiationInterval const& interval = loop.interval;
    Cycles const above_target = interval.recurrence_per_iteration + interval.port_conflict_per_iteration;
    if (loop.depth >= interval.achieved || above_target == 0)
        return 1;
    Cycles const target = interval.achieved - above_target;
    return std::max<std::uint64_t>(1, (interval.achieved - loop.depth + target - 1) / target);
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

}  // namespace dataflow::timing
