#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// What one loop iteration asks of one block RAM.
struct BramDemand {
    std::string bram;
    std::uint64_t accesses = 0;  ///< per iteration, worst branch
    std::uint64_t ports = 2;
};

/// The initiation interval of a loop and what it is made of (docs/timing-model.md#initiation-interval, as in modulo
/// scheduling).
struct InitiationInterval {
    Cycles target = 1;      ///< what the pragma asks for
    Cycles recurrence = 1;  ///< what a loop-carried dependence demands
    Cycles ports = 1;       ///< what the block RAM ports demand
    Cycles achieved = 1;    ///< the largest of the three
    Cycles port_conflict_per_iteration = 0;
    Cycles recurrence_per_iteration = 0;
    std::string limited_by;           ///< the block RAM, "recurrence", or empty
    std::string bram;                 ///< the block RAM that demands most; empty if the loop touches none
    std::uint64_t bram_accesses = 0;  ///< of that block RAM, per iteration
};

/// Schedules one iteration: II = max(target, recurrence, max over BRAMs of ceil(accesses / ports)). Between BRAMs that
/// demand the same, the first in `demands` counts.
InitiationInterval schedule(Cycles target, Cycles recurrence, std::vector<BramDemand> const& demands);

/// Steps of an iteration, by what makes them necessary.
struct IterationShares {
    Cycles own, recurrence, port_conflict;
};
/// The first `steps` steps of an iteration, at most all.
IterationShares shares_of(InitiationInterval const& interval, Cycles steps);

}  // namespace dataflow::timing
