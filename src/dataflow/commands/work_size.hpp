#pragma once
#include <cstddef>
#include <string>

#include "channels/simulated_design.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/run_config.hpp"
#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow {

/// Work that takes longer is announced.
constexpr double announced_s = 60;

/// How large the work of a command is, before it is done: right within a factor of three or so, on the host on which
/// the rates were measured.
struct WorkSize {
    std::string command;  ///< whose work it is, such as run
    std::string amount;   ///< what there is to be done, such as "620 samples, about 2.1e+10 loop iterations"
    double seconds = 0;   ///< of the host
    double bytes = 0;     ///< of memory, at its end
};

/// Of a simulation.
WorkSize size_of_run(RunConfig const& config, Machine const& machine, std::size_t samples,
                     LoopIterations const& iterations);
WorkSize size_of_run(RunConfig const& config, Machine const& machine, Workload const& workload);

/// Of so many retimings of a run, without their time: who makes one knows it.
WorkSize size_of_retimings(std::string const& command, replay::RecordedRun const& run, Machine const& machine,
                           double retimings);

/// Throws InputError if the host has less memory available.
void require_memory(WorkSize const& size);
/// Throws InputError if the work takes more than an hour.
void require_time(WorkSize const& size);
/// Throws InputError as these do, unless `force`, and says how large it is if it takes more than a minute.
void announce(WorkSize const& size, bool force);

/// Announces about so many retimings, on all of the host's cores. One is made, to see how long it takes.
void announce_retimings(std::string const& command, replay::RecordedRun const& run, Machine const& machine,
                        double retimings, bool force);

}  // namespace dataflow
