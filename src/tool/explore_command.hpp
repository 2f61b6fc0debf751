#pragma once
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `explore`.
struct ExploreRequest {
    std::string input;                   ///< event file, or a configuration to be run first
    std::vector<std::string> overrides;  ///< KEY=VALUE, of that run
    int port = 0;                        ///< 0: any
    bool force = false;                  ///< however long the run takes, whatever memory there is
};

/// Returns the exit code: exit_deadlock if the configuration deadlocks. Throws InputError on bad input.
int explore_run(ExploreRequest const& request);

Subcommand explore_command();

}  // namespace faster
