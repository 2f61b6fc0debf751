#pragma once
#include <functional>
#include <vector>

#include "dataflow/tools/sizing/search.hpp"

namespace dataflow::sizing {

/// What one FIFO of an answer would do if it were shallower, all others as they are.
struct CertificateRow {
    std::size_t fifo = 0;  ///< its number
    FifoChoice shallower;
    bool is_token_step = false;  ///< one token less
    bool is_cost_step = false;   ///< the deepest that costs less
    std::size_t core = 0;        ///< one that breaks the bound, if any does
    Cycles core_cycles = 0;      ///< that it takes, retimed: no less than the run; Cut::deadlock if it never ends

    bool breaks(Cycles bound) const { return core_cycles > bound; }
};

/// The steps down from a choice: for every FIFO one token less, and the deepest that costs less, where there are such.
/// A shallower FIFO of another kind that does not cost less is no step down. Not timed yet.
std::vector<CertificateRow> steps_down(FifoFrame const& frame, Choice const& choice);

/// Looks for a core that breaks the bound in each, the one that ends last as they are first; `done` is told after each
/// row, by the thread that timed it.
void time_steps(Choice const& choice, Cycles bound, CoreTimes& times, unsigned jobs, std::vector<CertificateRow>& rows,
                std::function<void()> const& done);

}  // namespace dataflow::sizing
