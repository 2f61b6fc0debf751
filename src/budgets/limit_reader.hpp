#pragma once
#include <vector>
#include <yaml-cpp/yaml.h>

#include "budgets/limit.hpp"
#include "config/key_faults.hpp"

namespace faster::budgets {

/// The map `limits` of a budget file. What is wrong with an entry is added to `faults`, and the entry left out.
std::vector<Limit> read_limits(YAML::Node const& limits, KeyFaults& faults);

}  // namespace faster::budgets
