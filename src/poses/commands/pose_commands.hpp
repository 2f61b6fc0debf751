#pragma once
#include <vector>

#include "dataflow/commands/subcommand.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Each a command of faster-sim, with its options.
Subcommand edge_quality_command();
Subcommand estimate_command();
Subcommand evaluate_command();
Subcommand experiment_command();
Subcommand grip_command();

/// All of them, as `--help` lists them; none in a program without poses (FASTER_BUILD_POSES).
std::vector<Subcommand> pose_commands();

}  // namespace faster
