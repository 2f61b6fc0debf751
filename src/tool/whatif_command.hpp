#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim whatif`.
struct WhatifRequest {
    std::string events;                  ///< file
    std::vector<std::string> overrides;  ///< KEY=VALUE
    std::string out;                     ///< folder; empty: print only
    std::string matrix;                  ///< file of configurations; empty: only the one
    std::string csv;                     ///< file, for the matrix; empty: print only
    std::int64_t top = 10;               ///< rows per list of the comparison
    bool force = false;                  ///< however long it takes, whatever memory there is
};

/// Returns the exit code: exit_deadlock if the configuration deadlocks, unless it is one of a matrix. Throws InputError
/// on bad input.
int whatif(WhatifRequest const& request);

/// `whatif`.
Subcommand whatif_command();

}  // namespace faster
