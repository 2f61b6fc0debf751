#pragma once
#include <functional>
#include <vector>

#include "kernel/sizing/repaired_search.hpp"

namespace faster::sizing {

/// The cheapest choice within one bound.
struct FrontPoint {
    Cycles bound = 0;  ///< no more than this; Cut::deadlock - 1: any that end
    Found found;
    Primitives primitives;  ///< of a core
    double cost = 0;        ///< of a core, in LUTs
};

/// Cost against cycles: the cheapest choice that ends at all, and the cheapest within `bound` and each of `points`
/// bounds, evenly spaced from there down to what unbounded FIFOs take. Those that another beats are left out; cheapest
/// first. `done` is told after each of the evenly spaced ones and the first.
std::vector<FrontPoint> front(FifoFrame const& frame, RepairedSearch& search, Cycles unbounded_cycles, Cycles bound,
                              unsigned points, std::function<void()> const& done);

}  // namespace faster::sizing
