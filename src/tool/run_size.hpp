#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "channels/simulate.hpp"
#include "channels/simulated_design.hpp"
#include "kernel/config/run_config.hpp"
#include "kernel/machine/machine.hpp"
#include "tool/recording_options.hpp"

namespace faster {

/// How long the files of a waveform will be.
struct WaveformSize {
    double vcd_bytes = 0;  ///< 0: there is none
    double fst_bytes = 0;
};

/// A run with these options.
using SimulateDesign = std::function<RunStatistics(SimulationOptions const& options)>;

/// The size of a whole run's waveform, right within a factor of two, before the run is made: its first samples are
/// simulated and recorded by a process of their own. `simulate`: the run, in that process. None if that process fails.
std::optional<WaveformSize> size_of_waveform(RecordingRequest const& request, Machine const& machine,
                                             std::size_t samples, SimulateDesign const& simulate);

/// Says how large the waveform will be, if the request asks for one without a window. Throws InputError if that is more
/// than 2 GB, unless `force`.
void announce_waveform(RecordingRequest const& request, Machine const& machine, std::size_t samples, bool force,
                       SimulateDesign const& simulate);

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
