#pragma once
#include <string>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim sensitivities`.
struct SensitivitiesRequest {
    std::string events;  ///< file
    std::string csv;     ///< file; empty: none
    std::string json;    ///< file; empty: none
    bool force = false;  ///< however long it takes, whatever memory there is
};

/// Returns the exit code; throws InputError on bad input.
int print_sensitivities(SensitivitiesRequest const& request);

/// `sensitivities`.
Subcommand sensitivities_command();

}  // namespace faster
