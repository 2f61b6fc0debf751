#pragma once
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `record`.
struct RecordRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;
    bool force = false;  ///< however long it takes, whatever memory there is
};

/// Returns the exit code; throws InputError on bad input.
int record(RecordRequest const& request);

Subcommand record_command();

}  // namespace faster
