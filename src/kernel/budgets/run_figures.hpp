#pragma once
#include "kernel/budgets/figures.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::budgets {

/// Every figure of a finished run: those of the run, of all cores together (see is_largest_over_cores), of each sample,
/// and of each core under "cores.N.". Names and values are those of summary.json and samples.csv.
Figures run_figures(RunStatistics const& run);

}  // namespace faster::budgets
