#pragma once
#include <vector>

#include "dataflow/core/time/operation.hpp"

namespace dataflow::replay {

/// Operations in one form, however the process told them: iterations that access the same ports, with one silent
/// iteration behind them or none, are cut into operations by a rule of their own. How many of them a process tells at
/// once depends on how many tokens it finds, which is the host's affair and differs between engines.
std::vector<timing::Operation> canonical(timing::Operation const* first, std::size_t count);

/// For a process whose loop mixes iterations of several ports: of equal ones the first, if it was told alone, is the
/// tail of the operation before them. It becomes part of theirs, as if they had been told together.
void return_tails(std::vector<timing::Operation>& operations);

}  // namespace dataflow::replay
