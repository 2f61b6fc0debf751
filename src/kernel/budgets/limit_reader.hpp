#pragma once
#include <vector>
#include <yaml-cpp/yaml.h>

#include "kernel/budgets/limit.hpp"
#include "kernel/config/key_faults.hpp"

namespace faster::budgets {

/// The map `limits` of a budget file. What is wrong with an entry is added to `faults`, and the entry left out.
std::vector<Limit> read_limits(YAML::Node const& limits, KeyFaults& faults);

}  // namespace faster::budgets
