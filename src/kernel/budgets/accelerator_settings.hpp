#pragma once
#include <vector>

#include "kernel/budgets/budget.hpp"
#include "kernel/config/resolved_config.hpp"

namespace faster::budgets {

/// The keys of the accelerator that do not have their defaults.
std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys);

}  // namespace faster::budgets
