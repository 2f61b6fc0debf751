#include "dataflow/core/time/initiation_interval.hpp"

#include <algorithm>

namespace dataflow::timing {

InitiationInterval schedule(Cycles target, Cycles recurrence, std::vector<BramDemand> const& demands) {
    InitiationInterval interval;
    interval.target = target;
    interval.recurrence = recurrence;
    BramDemand const* hardest = nullptr;
    for (BramDemand const& demand : demands) {
        Cycles const needed = (demand.accesses + demand.ports - 1) / demand.ports;
        interval.ports = std::max(interval.ports, needed);
        // Quotients are compared as fractions, so that 3 accesses on 2 ports weigh more than 2 on 2.
        if (hardest == nullptr || demand.accesses * hardest->ports > hardest->accesses * demand.ports)
            hardest = &demand;
    }
    Cycles const without_ports = std::max(target, recurrence);
    interval.achieved = std::max(without_ports, interval.ports);
    interval.port_conflict_per_iteration = interval.achieved - without_ports;
    interval.recurrence_per_iteration = recurrence > target ? recurrence - target : 0;
    if (hardest != nullptr) {
        interval.bram = hardest->bram;
        interval.bram_accesses = hardest->accesses;
    }
    if (interval.port_conflict_per_iteration > 0)
        interval.limited_by = interval.bram;
    else if (interval.recurrence_per_iteration > 0)
        interval.limited_by = "recurrence";
    return interval;
}

IterationShares shares_of(InitiationInterval const& interval, Cycles steps) {
    Cycles const own = std::min(steps, interval.target);
    Cycles const recurrence = std::min(steps - own, interval.recurrence_per_iteration);
    return {own, recurrence, steps - own - recurrence};
}

}  // namespace dataflow::timing
