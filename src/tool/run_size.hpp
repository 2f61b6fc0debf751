#pragma once
#include <cstddef>
#include <string>

#include "channels/simulated_design.hpp"
#include "kernel/config/run_config.hpp"
#include "kernel/machine/machine.hpp"

namespace faster {

/// How large a run is, before it is made: right within a factor of three or so, on the host on which this was measured.
struct RunSize {
    std::size_t samples = 0;
    LoopIterations iterations;
    double seconds = 0;  ///< of the host
    double bytes = 0;    ///< of memory, at its end
};

RunSize size_of_run(RunConfig const& config, Machine const& machine, Workload const& workload);

/// "620 samples, about 2.1e+10 loop iterations: about 12 minutes, 1.2 GiB"
std::string text_of(RunSize const& size);

/// Throws InputError if the host has less memory available.
void require_memory(RunSize const& size);
/// Throws InputError if the run would take more than an hour.
void require_time(RunSize const& size);

}  // namespace faster
