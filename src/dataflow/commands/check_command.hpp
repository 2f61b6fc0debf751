#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/commands/subcommand.hpp"

namespace dataflow {

/// `faster-sim check`.
struct CheckRequest {
    std::vector<std::string> budgets;
    std::vector<std::string> overrides;  ///< KEY=VALUE, on top of every budget's own
    std::string junit;                   ///< file; empty: none
    std::string json;                    ///< file; empty: none
    std::int64_t jobs = 0;               ///< processes at once; 0: as many as the host has cores
    double time_limit_s = 0;             ///< per budget; 0: as the budgets say
    bool update = false;                 ///< rewrite the baselines
    std::string reason;
    std::string init;   ///< configuration to start a budget from; empty: check
    std::string trace;  ///< for init
    std::string out;    ///< for init
};

/// Runs every budget and compares. Returns exit_bad_input if a budget turns out to be at fault, else exit_failed_check
/// if one fails, else exit_done. Throws InputError on what can be seen before anything runs.
int check(CheckRequest const& request);

/// `check`.
Subcommand check_command();

}  // namespace dataflow
