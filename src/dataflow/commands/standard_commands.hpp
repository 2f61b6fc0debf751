#pragma once
#include <vector>

#include "dataflow/commands/subcommand.hpp"

namespace dataflow {

/// The commands that any design has: run, check, explore, whatif, sensitivities, size-fifos, compare, sweep, schedule,
/// keys.
std::vector<Subcommand> standard_commands();

/// Those of them that need nothing but their options.
Subcommand compare_command();
Subcommand explore_command();
Subcommand keys_command();
Subcommand schedule_command();
Subcommand sensitivities_command();
Subcommand size_fifos_command();
Subcommand whatif_command();

}  // namespace dataflow
