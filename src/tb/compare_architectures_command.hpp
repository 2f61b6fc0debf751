#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim compare-architectures`.
struct CompareArchitecturesRequest {
    /// Presets by name, or configuration files that say what an architecture changes. Empty: all presets, `faster`
    /// first.
    std::vector<std::string> architectures;
    std::vector<std::string> workloads;  ///< configuration files to run them on
    std::vector<std::string> overrides;  ///< KEY=VALUE, for all
    std::int64_t jobs = 0;               ///< simulations at once; 0: the host's cores
    std::int64_t judged_samples = 0;     ///< how many edge maps to judge in every run
    bool force = false;                  ///< however long each takes, whatever memory there is
    std::string csv;                     ///< file; empty: none
    std::string html;                    ///< the same
};

/// Runs every architecture on every workload, each in a process of its own, and prints a table. The keys an
/// architecture's file sets win over the workload's. Throws InputError on bad input. Exit code 1 if a simulation
/// crashed.
int compare_architectures(CompareArchitecturesRequest const& request);

/// `compare-architectures`.
Subcommand compare_architectures_command();

}  // namespace faster
