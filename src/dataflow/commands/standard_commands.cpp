#include "tool/standard_commands.hpp"

#include "tool/check_command.hpp"
#include "tool/run_command.hpp"
#include "tool/sweep_command.hpp"

namespace faster {

std::vector<Subcommand> standard_commands() {
    return {run_command(),        check_command(),   explore_command(), whatif_command(), sensitivities_command(),
            size_fifos_command(), compare_command(), sweep_command(),   keys_command()};
}

}  // namespace faster
