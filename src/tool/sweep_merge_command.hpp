#pragma once
#include <string>
#include <vector>

namespace faster {

/// `faster-sim sweep merge`.
struct SweepMergeRequest {
    std::vector<std::string> folders;
    std::string out;  ///< folder
};

/// Returns the exit code: exit_failed_check if points are missing, or one failed. Throws InputError on bad input.
int merge_sweeps(SweepMergeRequest const& request);

}  // namespace faster
