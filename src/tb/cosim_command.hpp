#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `cosim`.
struct CosimRequest {
    std::string trace;                        ///< folder
    std::string config;                       ///< file; empty: defaults
    std::vector<std::string> overrides;       ///< of model and twin
    std::vector<std::string> twin_overrides;  ///< of the twin alone, to see a difference found
    std::string out = ".";                    ///< folder for the waveforms of a difference
    std::int64_t core = -1;                   ///< -1: all
    bool forwards = true;                     ///< see TwinSettings
};

/// Returns the exit code, 1 if model and twin differ; throws InputError on bad input.
int cosim(CosimRequest const& request);

Subcommand cosim_command();

}  // namespace faster
