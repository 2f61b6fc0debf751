#pragma once
#include "dataflow/tools/budgets/budget.hpp"

namespace dataflow::budgets {

enum class BaselineNeed { required, optional };

/// Reads a budget file. Throws InputError that names file and line for what is wrong with it: an unknown key or figure,
/// a pattern that can match nothing, limits that no figure can keep, a wrong unit, a missing baseline. Whether the
/// configuration exists, and how many cores and samples there are, turns out later.
Budget read_budget(std::filesystem::path const& file, BaselineNeed need = BaselineNeed::required);

}  // namespace dataflow::budgets
