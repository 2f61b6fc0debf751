#include "kernel/timing/process_shape.hpp"

#include <algorithm>
#include <map>

namespace faster::timing {

LoopPlan::LoopPlan(LoopShape const& loop) : ii(loop.interval.achieved), counting(iterations_that_count(loop)) {
    Cycles shortest = loop.writes.empty() || !loop.reads.empty() ? 0 : loop.writes.front().write_latency;
    for (LoopWrite const& write : loop.writes)
        shortest = std::min(shortest, write.write_latency);
    std::vector<LoopWrite> accesses = loop.writes;
    for (unsigned const port : loop.reads)
        accesses.push_back({port, 0});
    aligned = loop.reads.empty();  // otherwise not all accesses have one direction
    std::map<Cycles, LoopPhase> phase_at;
    for (LoopWrite const& access : accesses) {
        Cycles const behind = access.write_latency - shortest;
        aligned = aligned && behind == 0;
        longest_lag = std::max(longest_lag, behind / ii);
        LoopPhase& phase = phase_at[behind % ii];
        phase.offset = behind % ii;
        phase.ports.emplace_back(access.port, behind / ii);
    }
    for (auto& phase : phase_at)
        phases.push_back(std::move(phase.second));
    fill = shortest;
    drain = static_cast<std::int64_t>(loop.depth) - static_cast<std::int64_t>(ii + shortest);
    while (delay_line_length <= longest_lag)
        delay_line_length *= 2;
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

}  // namespace faster::timing
