#pragma once
#include <functional>
#include <optional>

#include "channels/simulate.hpp"
#include "dataflow/commands/recording_options.hpp"

namespace dataflow {

/// How long the files of a waveform will be.
struct WaveformSize {
    double vcd_bytes = 0;  ///< 0: there is none
    double fst_bytes = 0;
};

/// A run with these options.
using SimulateDesign = std::function<RunStatistics(SimulationOptions const& options)>;

/// The size of the waveform, right within a factor of two, before the run is made: its first samples are
/// simulated and recorded by a process of their own. `simulate`: the run, in that process. None if that process fails,
/// and for a window of so few cycles that it cannot be large. Throws InputError for a window that is none.
std::optional<WaveformSize> size_of_waveform(RecordingRequest const& request, Machine const& machine,
                                             std::size_t samples, SimulateDesign const& simulate);

/// Says how large the waveform will be, if the request asks for one. Throws InputError if that is more than 2 GB,
/// unless `force`.
void announce_waveform(RecordingRequest const& request, Machine const& machine, std::size_t samples, bool force,
                       SimulateDesign const& simulate);

}  // namespace dataflow
