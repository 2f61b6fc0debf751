#include "poses/commands/pose_commands.hpp"

namespace faster {

std::vector<Subcommand> pose_commands() { return {}; }

}  // namespace faster
