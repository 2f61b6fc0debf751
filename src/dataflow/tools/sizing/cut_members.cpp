#include "dataflow/tools/sizing/cut_members.hpp"

#include <algorithm>

#include "dataflow/run/replay/path_sweep.hpp"

namespace dataflow::sizing {

namespace {

/// How often a path turns at a port of a process, wherever in its program.
std::uint64_t turns_at(timing::ProcessTiming const& process, unsigned port, timing::PathSums const& path) {
    auto const loops = static_cast<unsigned>(process.loops().size());
    std::uint64_t turns = 0;
    for (unsigned number = 0; number < timing::Region::count(loops); ++number)
        turns += path.turns(process.index(), timing::Region::numbered(number), port);
    return turns;
}

/// Those that hold anybody up.
Members those_that_hold_up(Members const& members) {
    Members kept;
    for (std::size_t i = 0; i < members.size(); ++i)
        if (members[i].capacity > 0 || members[i].is_slow) {
            kept.push_back(members[i]);
            kept.back().fifo = i;
        }
    return kept;
}

/// The processes that wait for each other in a circle; others may only wait for these.
std::vector<timing::BlockedProcess> circle_of(std::vector<timing::BlockedProcess> const& waits) {
    std::vector<timing::BlockedProcess> chain;
    for (std::string next = waits.front().process;;) {
        auto const waits_there = [&next](timing::BlockedProcess const& wait) { return wait.process == next; };
        auto const seen = std::find_if(chain.begin(), chain.end(), waits_there);
        if (seen != chain.end())
            return {seen, chain.end()};
        auto const wait = std::find_if(waits.begin(), waits.end(), waits_there);
        if (wait == waits.end())
            return waits;
        chain.push_back(*wait);
        next = wait->other;
    }
}

}  // namespace

Members members_of_path(timing::CoreTiming const& core, RunEnd const& end) {
    timing::PathSums const path = critical_path(core, static_cast<unsigned>(end.process), end.cycle);
    Members members(core.fifos().size());
    for (timing::ProcessTiming const& process : core.processes())
        for (unsigned port = 0; port < process.port_count(); ++port) {
            timing::FifoTiming const& fifo = process.fifo(port);
            if (fifo.is_stream() || turns_at(process, port, path) == 0)
                continue;
            Cut::Member& member = members[core.number_of(fifo)];
            if (process.writes(port))
                member.capacity = fifo.shape().capacity;
            else
                member.is_slow = fifo.shape().read_latency > 1;
        }
    return those_that_hold_up(members);
}

Members members_of_deadlock(timing::CoreTiming& core) {
    Members members(core.fifos().size());
    for (timing::BlockedProcess const& wait : circle_of(core.blocked()))
        for (std::size_t i = 0; i < members.size(); ++i)
            if (wait.to_write && wait.fifo == core.fifos()[i].name())
                members[i].capacity = wait.capacity;
    return those_that_hold_up(members);
}

}  // namespace dataflow::sizing
