#pragma once
#include <vector>

#include "dataflow/tools/compare/comparison.hpp"
#include "dataflow/tools/compare/run_record.hpp"

namespace dataflow::runs {

/// Keys of both runs: those of A in their order, with what B says, then those that only B has.
std::vector<SettingChange> joined(std::vector<ConfigurationEntry> const& a, std::vector<ConfigurationEntry> const& b);

/// Those that differ.
std::vector<SettingChange> changed(std::vector<SettingChange> rows);

/// What changed from run A to run B. Samples are compared by their numbers.
Comparison compare(RunRecord const& a, RunRecord const& b);

}  // namespace dataflow::runs
