#pragma once
#include <string>
#include <vector>

#include "kernel/budgets/check_result.hpp"

namespace faster::budgets {

/// All results as a JSON file (docs/formats.md, "Results of a check").
std::string check_json(std::vector<CheckResult> const& results);

}  // namespace faster::budgets
