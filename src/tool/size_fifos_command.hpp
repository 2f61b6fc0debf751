#pragma once
#include <string>
#include <vector>

#include "kernel/machine/fifo_cost.hpp"
#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim size-fifos`.
struct SizeFifosRequest {
    std::string events;         ///< file
    double within_percent = 0;  ///< of what unbounded FIFOs take, more
    std::string out;            ///< folder; empty: none
    double luts_per_ramb36 = CostWeights().luts_per_ramb36;
    unsigned front_points = 12;
    unsigned jobs = 0;  ///< threads; 0: the host's cores
    std::vector<std::string> overrides;
    bool force = false;  ///< however long it takes, whatever memory there is
};

/// Returns the exit code; throws InputError on bad input.
int print_fifo_sizes(SizeFifosRequest const& request);

/// `size-fifos`.
Subcommand size_fifos_command();

}  // namespace faster
