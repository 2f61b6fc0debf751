#pragma once
#include <cstdint>
#include <string>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim experiment`.
struct ExperimentRequest {
    std::string file;
    std::string out;
    std::int64_t jobs = 0;     ///< processes at once; 0: the host's cores
    bool force = false;        ///< however long it takes
    std::size_t failures = 8;  ///< pictures of a setting
};

/// Makes the scenes of an experiment file, looks for every object with every method, and judges what came out. Goes on
/// where it was if it has been interrupted. Throws InputError on bad input. Exit code 1 if an estimate crashed.
int experiment(ExperimentRequest const& request);

/// `experiment`.
Subcommand experiment_command();

}  // namespace faster
