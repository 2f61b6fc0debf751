#pragma once
#include <cstdint>
#include <string>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim show`.
struct ShowRequest {
    std::string folder;       ///< results of a run
    std::int64_t sample = 0;  ///< index
    std::int64_t width = 0;   ///< columns; 0: what fits the terminal
    bool depth = false;       ///< the depth buffer rather than the contour
};

/// Prints a sample's figures and a small picture of it. Returns the exit code; throws InputError on bad input.
int show(ShowRequest const& request);

/// `show`.
Subcommand show_command();

}  // namespace faster
