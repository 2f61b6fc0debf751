#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim grip`.
struct GripRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;        ///< folder for scores.csv and summary.json; empty: print only
    std::int64_t jobs = 0;  ///< threads; 0: the host's cores
    bool force = false;     ///< however long it takes, whatever memory there is
    double inlier_distance_m = 0.008;
};

/// Scores a configuration's poses by the thesis's CPU + GPU baseline, and compares them with those of the configured
/// flow. Throws InputError on bad input.
int grip_baseline(GripRequest const& request);

/// `grip`.
Subcommand grip_command();

}  // namespace faster
