#pragma once
#include <string>

#include "dataflow/tools/budgets/budget.hpp"
#include "dataflow/tools/budgets/measurement.hpp"

namespace dataflow::budgets {

/// The baseline that a finished run makes for a budget: all figures of all cores together, and of single cores and
/// samples those that a limit compares with the baseline.
Baseline baseline_of(Measurement const& measurement, std::vector<Limit> const& limits, std::string const& date,
                     std::string const& reason);

/// Whether both say the same of a run, whatever their dates and reasons.
bool is_same_run(Baseline const& a, Baseline const& b);

/// The block `baseline:` of a budget file, one figure's item per line.
std::string baseline_block(Baseline const& baseline);

}  // namespace dataflow::budgets
