#pragma once
#include <string>
#include <vector>

#include "kernel/budgets/check_result.hpp"

namespace faster::budgets {

/// A result for people: a table of limits, and after a breach what moved since the baseline. Figures only, no host
/// times: equal runs print equal text.
std::string check_text(CheckResult const& result);

/// What moved, a line each; the largest `top` of each kind.
std::string explanation_text(Explanation const& explanation, std::size_t top);

/// "12 budgets: 11 passed, 1 breached".
std::string totals_text(std::vector<CheckResult> const& results);

}  // namespace faster::budgets
