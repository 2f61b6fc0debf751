#pragma once
#include <string>
#include <vector>

#include "dataflow/tools/budgets/check_result.hpp"
#include "dataflow/tools/budgets/evaluate.hpp"

namespace dataflow::budgets {

/// A limit for people, e.g. "max 1.5 ms = 300000": in the budget's words, and in cycles where these are others.
std::string limit_text(Limit const& limit, Interval const& allowed);

/// One sentence on a breach: "samples.3.latency_cycles = 5112, expected exact baseline = 5110: 2 cycles above".
std::string breach_text(Limit const& limit, FigureCheck const& breach);

/// A result for people: a table of limits, and after a breach what moved since the baseline. Figures only, no host
/// times: equal runs print equal text.
std::string check_text(CheckResult const& result);

/// What moved, a line each; the largest `top` of each kind.
std::string explanation_text(Explanation const& explanation, std::size_t top);

/// "12 budgets: 11 passed, 1 breached".
std::string totals_text(std::vector<CheckResult> const& results);

}  // namespace dataflow::budgets
