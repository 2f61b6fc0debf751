#pragma once
#include <string>

#include "kernel/base/column.hpp"

namespace faster::budgets {

/// What the tables of columns say of a figure. Of a name that they do not know (a baseline may be older than they are):
/// work without a unit.
ColumnFacts const& facts_of(std::string const& name);

/// True for what is counted in clock cycles (of all cores together: lane-cycles), which a limit may give as a time too.
inline bool is_in_cycles(std::string const& name) { return facts_of(name).is_in_cycles(); }

}  // namespace faster::budgets
