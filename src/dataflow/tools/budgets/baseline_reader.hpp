#pragma once
#include <yaml-cpp/yaml.h>

#include "kernel/budgets/budget.hpp"
#include "kernel/config/key_faults.hpp"

namespace faster::budgets {

/// The map `baseline` of a budget file, which starts in `line`. What is wrong with it is added to `faults`.
Baseline read_baseline(YAML::Node const& node, int line, KeyFaults& faults);

}  // namespace faster::budgets
