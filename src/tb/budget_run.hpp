#pragma once
#include <string>
#include <vector>

#include "budgets/budget.hpp"
#include "budgets/measurement.hpp"

namespace faster {

/// Simulates what a budget is about, with `overrides` on top of its own, and takes all figures. Goes to the budget's
/// folder first, since that is what its paths are relative to, so call it in a process of its own. Does not throw.
budgets::Measurement measure(budgets::Budget const& budget, std::vector<std::string> const& overrides);

}  // namespace faster
