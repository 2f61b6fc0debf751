#pragma once
#include <string>
#include <vector>

#include "kernel/budgets/budget.hpp"
#include "kernel/config/resolved_config.hpp"

namespace faster::budgets {

/// "fnv1a64:" and 16 hexadecimal digits: the FNV-1a hash (64 bits, offset 14695981039346656037, prime 1099511628211) of
/// the lines "KEY=VALUE\n" of all keys in the order of configs/README.md, values as JSON. What decides no figure is
/// left out: it changes neither function nor time.
std::string configuration_hash(std::vector<ResolvedKey> const& keys);

/// The keys of the accelerator that do not have their defaults.
std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys);

}  // namespace faster::budgets
