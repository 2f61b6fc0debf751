#pragma once
#include "kernel/budgets/budget.hpp"
#include "kernel/budgets/measurement.hpp"
#include "kernel/config/design.hpp"

namespace faster::budgets {

/// The text of a first budget for a run: commented, and kept by that run. `budget` says what was run (limits and
/// baseline do not matter), `date` is today.
std::string starting_budget(Budget const& budget, Measurement const& measurement, Design::Guarded const& guarded,
                            std::string const& date);

}  // namespace faster::budgets
