#pragma once
#include "tool/subcommand.hpp"

namespace faster {

/// Each a command of faster-sim, with its options; `evaluate` is in evaluate_command.hpp.
Subcommand compare_architectures_command();
Subcommand cosim_command();
Subcommand edge_quality_command();
Subcommand estimate_command();
Subcommand experiment_command();
Subcommand grip_command();
Subcommand record_command();
Subcommand show_command();

}  // namespace faster
