#pragma once
#include <cstdint>
#include <string>

#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim compare`.
struct CompareRequest {
    std::string run_a;      ///< output folder of a run
    std::string run_b;      ///< and of another
    std::int64_t top = 10;  ///< rows per list
    std::string json;       ///< file; empty: print only
};

/// Returns exit_failed_check if the runs have other samples or score one differently, and exit_done if nothing but time
/// differs. Throws InputError on bad input.
int compare(CompareRequest const& request);

/// `compare`.
Subcommand compare_command();

}  // namespace faster
