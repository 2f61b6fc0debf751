#pragma once
#include <cstdint>
#include <string>

#include "dataflow/commands/subcommand.hpp"

namespace dataflow {

/// `faster-sim sweep`.
struct SweepRequest {
    std::string sweep;            ///< file
    std::string out;              ///< folder
    std::string shard;            ///< "I/N"; empty: all points
    std::int64_t jobs = 0;        ///< processes at once; 0: as many as the host has cores
    double time_limit_s = 86400;  ///< of a point
    bool keep_events = false;     ///< also of functions that are done
    bool retry_failed = false;    ///< points that failed before are done again
};

/// Returns the exit code: exit_failed_check if a point failed. Throws InputError on bad input, and if nothing can be
/// written; what is in the folder then is whole, and the next sweep goes on from there.
int sweep(SweepRequest const& request);

/// `sweep`, and `sweep merge`.
Subcommand sweep_command();

}  // namespace dataflow
