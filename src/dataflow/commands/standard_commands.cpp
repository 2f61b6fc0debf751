#include "dataflow/commands/standard_commands.hpp"

#include "dataflow/commands/check_command.hpp"
#include "dataflow/commands/run_command.hpp"
#include "dataflow/commands/sweep_command.hpp"

namespace dataflow {

std::vector<Subcommand> standard_commands() {
    return {run_command(),        check_command(),   explore_command(), whatif_command(),   sensitivities_command(),
            size_fifos_command(), compare_command(), sweep_command(),   schedule_command(), keys_command()};
}

}  // namespace dataflow
