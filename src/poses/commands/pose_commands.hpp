#pragma once
#include "dataflow/commands/subcommand.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Each a command of faster-sim, with its options; `evaluate` is in evaluate_command.hpp.
Subcommand edge_quality_command();
Subcommand estimate_command();
Subcommand experiment_command();
Subcommand grip_command();

}  // namespace faster
