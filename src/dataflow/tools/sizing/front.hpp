#pragma once
#include <functional>
#include <vector>

#include "dataflow/tools/sizing/search.hpp"

namespace dataflow::sizing {

/// Searches for the cheapest FIFOs of a machine whose times need not be monotone.
///
/// The cheapest of the relaxed machine cost no more than those of the machine itself, as every choice within the bound
/// here is within it there. If they are within the bound here too, they are the answer. If not, they are repaired: a
/// second search goes on from the same cuts with the times of the machine itself. All that it finds is timed; that it
/// is the cheapest is proven only if it costs no more than the relaxed machine's.
class RepairedSearch {
  public:
    RepairedSearch(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded, SearchOptions const& options);

    /// At most `bound` cycles, which must be no less than unbounded FIFOs take; Cut::deadlock - 1: any that end.
    Found cheapest(Cycles bound);
    Found timed(Found found) { return exact_.timed(std::move(found)); }
    /// A choice of equal price with no token more than needed; timed.
    Found shallowest(Found const& found, Cycles bound);
    /// Another choice within the bound, instead of one found.
    Found replaced(Found found, Choice const& choice) const;

  private:
    bool const is_monotone_;
    Search relaxed_;
    Search exact_;
};

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

}  // namespace dataflow::sizing
