#pragma once
#include <string>
#include <vector>

#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/check_command.hpp"
#include "dataflow/tools/budgets/budget.hpp"
#include "dataflow/tools/budgets/measurement.hpp"

namespace dataflow {

/// Simulates what a budget is about, with `overrides` on top of its own, and takes all figures. Goes to the budget's
/// folder first, since that is what its paths are relative to, so call it in a process of its own. Does not throw.
budgets::Measurement measure(budgets::Budget const& budget, std::vector<std::string> const& overrides);

/// measure() for every budget, each in a process of its own; the request says how many at once and for how long. The
/// output of an outcome is a measurement as text.
std::vector<processes::Outcome> run_budgets(std::vector<budgets::Budget> const& budgets,
                                            std::vector<std::string> const& overrides, CheckRequest const& request,
                                            processes::SignalWatch const& watch);

/// In seconds: the request's, else the budget's.
double time_limit_of(budgets::Budget const& budget, CheckRequest const& request);

/// One sentence on a process that ended without a result. `limit`: what sets its time limit.
std::string why_no_result(processes::Outcome const& outcome, double time_limit_s,
                          std::string_view limit = "time_limit_s, --time-limit");

/// YYYY-MM-DD, UTC.
std::string today();

}  // namespace dataflow
