#include "poses/commands/pose_commands.hpp"

namespace faster {

std::vector<Subcommand> pose_commands() {
    return {edge_quality_command(), grip_command(), estimate_command(), evaluate_command(), experiment_command()};
}

}  // namespace faster
