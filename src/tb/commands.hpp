#pragma once
#include "dataflow/commands/subcommand.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Each a command of faster-sim, with its options; those around poses are in poses/commands.
Subcommand cosim_command();
Subcommand record_command();

}  // namespace faster
