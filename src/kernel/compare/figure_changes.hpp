#pragma once
#include <vector>

#include "kernel/compare/comparison.hpp"
#include "kernel/compare/run_record.hpp"

namespace faster::runs {

/// The figures that moved from run A to run B, a list per kind; lists without changes are there, but empty. Figures of
/// several cores are summed, occupancies and initiation intervals are the largest of any core.
std::vector<ChangeList> figure_changes(RunRecord const& a, RunRecord const& b);

}  // namespace faster::runs
