#pragma once
#include <optional>
#include <vector>

#include "dataflow/tools/sizing/cut.hpp"

namespace dataflow::sizing {

/// The levels of each FIFO, the cheapest first.
using Levels = std::vector<std::vector<Level>>;

/// What the primitives of a choice take together, in one core.
Primitives sum_of(Choice const& choice, Freedoms const& fifos, CostWeights const& weights);

/// The cheapest combination of levels that escapes all cuts; of equally cheap ones always the same. Empty if there is
/// none. Exact: branches on who escapes a cut, and leaves a branch once it costs what the best so far costs.
std::optional<Choice> cheapest_choice(Levels const& levels, std::vector<Cut> const& cuts);

}  // namespace dataflow::sizing
