#pragma once
#include <yaml-cpp/yaml.h>

#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/tools/budgets/budget.hpp"

namespace dataflow::budgets {

/// The map `baseline` of a budget file, which starts in `line`. What is wrong with it is added to `faults`.
Baseline read_baseline(YAML::Node const& node, int line, KeyFaults& faults);

}  // namespace dataflow::budgets
