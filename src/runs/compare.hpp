#pragma once
#include "runs/comparison.hpp"
#include "runs/run_record.hpp"

namespace faster::runs {

/// What changed from run A to run B. Samples are compared by their numbers.
Comparison compare(RunRecord const& a, RunRecord const& b);

}  // namespace faster::runs
