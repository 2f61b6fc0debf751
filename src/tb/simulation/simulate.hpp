#pragma once
#include <functional>

#include "common/stimulus.hpp"
#include "faster/run_config.hpp"
#include "kernel/figures/run_statistics.hpp"
#include "kernel/recording/vcd_core.hpp"
#include "kernel/replay/recorded_run.hpp"
#include "modules/core_context.hpp"

namespace faster {

/// Something to be recorded, and what to do with it when the run is over, or stuck. Cores that score none of the wanted
/// samples are left out.
struct Recording {
    recording::RecordingWindow window;
    std::function<void(std::vector<recording::RecordedCore> const& cores)> done;
};

struct SimulationOptions {
    SampleProbe* probe = nullptr;                      ///< sees the maps of every sample; may be null
    std::function<void(std::uint64_t done)> progress;  ///< called with the number of samples done; may be empty
    std::vector<Recording> recordings;
    retiming::RecordedRun* recorded = nullptr;               ///< takes down what was done; may be null
    bool critical_path = false;                              ///< to be traced
    std::size_t trail_length = timing::Trail::usual_length;  ///< see there; decides about memory only
};

/// Builds the accelerator, runs it until nothing moves, and collects its figures. A deadlock is a result, not an error:
/// see RunStatistics::stuck. The SystemC kernel elaborates once per process, so call this once per process.
RunStatistics simulate(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                       SimulationOptions const& options = {});

}  // namespace faster
