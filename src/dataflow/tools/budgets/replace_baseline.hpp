#pragma once
#include <string>

#include "dataflow/tools/budgets/budget.hpp"

namespace dataflow::budgets {

/// The text of a budget file with another baseline. All else stays as it is, letter for letter. Comments inside the old
/// baseline stay too: a line of its own above the key it stood above, one beside a key beside it. The new text is read
/// back and compared; throws InputError if something else would have changed (say, for a file in flow style).
std::string replace_baseline(std::string const& text, Baseline const& baseline, std::string const& file);

}  // namespace dataflow::budgets
