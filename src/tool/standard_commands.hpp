#pragma once
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// The commands that any design has: run, check, explore, whatif, sensitivities, size-fifos, compare, sweep, keys.
std::vector<Subcommand> standard_commands();

}  // namespace faster
