#pragma once
#include "dataflow/tools/budgets/budget.hpp"
#include "dataflow/tools/budgets/measurement.hpp"

namespace dataflow::budgets {

/// Figures of the simulated design that a first budget guards.
struct GuardedFigures {
    std::string counter;  ///< of samples: none may score differently; empty: there are no counters
    std::string module;   ///< whose wait for input may move a little
};

/// The text of a first budget for a run: commented, and kept by that run. `budget` says what was run (limits and
/// baseline do not matter), `date` is today.
std::string starting_budget(Budget const& budget, Measurement const& measurement, GuardedFigures const& guarded,
                            std::string const& date);

}  // namespace dataflow::budgets
