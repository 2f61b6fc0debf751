#pragma once
#include <vector>

#include "kernel/compare/comparison.hpp"
#include "kernel/compare/run_record.hpp"

namespace faster::runs {

/// Keys of both runs: those of A in their order, with what B says, then those that only B has.
std::vector<SettingChange> joined(std::vector<ConfigurationEntry> const& a, std::vector<ConfigurationEntry> const& b);

/// Those that differ.
std::vector<SettingChange> changed(std::vector<SettingChange> rows);

}  // namespace faster::runs
