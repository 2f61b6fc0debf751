#pragma once
#include "kernel/compare/comparison.hpp"
#include "kernel/compare/run_record.hpp"

namespace faster::runs {

/// What changed from run A to run B. Samples are compared by their numbers.
Comparison compare(RunRecord const& a, RunRecord const& b);

}  // namespace faster::runs
