#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "channels/dataflow_accelerator.hpp"
#include "dataflow/core/time/trail.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/tools/recording/recorded_window.hpp"
#include "dataflow/tools/recording/recording_window.hpp"

namespace dataflow {

/// Something to be recorded, and what to do with it when the run is over, or stuck. Cores that do none of the wanted
/// samples are left out.
struct Recording {
    recording::RecordingWindow window;
    std::function<void(recording::RecordedWindow const& window)> done;
};

struct SimulationOptions {
    std::function<void(std::uint64_t done)> progress;  ///< called with the number of samples done; may be empty
    std::vector<Recording> recordings;
    /// Takes down what was done; may be null. Of a run that gets stuck only what cores do that keep the time (as for a
    /// critical path), for a look at it: samples that have not ended are there as far as they got.
    replay::RecordedRun* recorded = nullptr;
    /// The run ends when the first core has done so many; what is recorded by then is handed over, and the figures are
    /// empty.
    std::size_t most_samples = ~std::size_t{0};
    /// Cores of the host that the run may use (decoupled). Figures do not depend on it.
    ///   With figures_alone, and nothing recorded or traced, so many processes have some of the cores each.
    ///   Else a second thread beside that of the SystemC kernel gives operations their cycles, where no more is
    ///   recorded than what was done, and nothing is traced.
    /// Neither behind an external memory.
    std::size_t jobs = 1;
    bool figures_alone = false;                              ///< nobody looks at the modules when the run is over
    bool critical_path = false;                              ///< to be traced
    bool at_any_size = false;                                ///< even if there seems to be too little memory
    bool hazards = false;                                    ///< to be looked for
    std::size_t trail_length = timing::Trail::usual_length;  ///< see there; decides about memory only

    bool leaves_early() const { return most_samples != SimulationOptions{}.most_samples; }
    /// Somebody looks at cycles while the run goes on.
    bool looks_at_cycles() const { return critical_path || !recordings.empty() || leaves_early(); }
};

/// Runs the accelerator until nothing moves, and collects its figures. A deadlock is a result, not an error: see
/// RunStatistics::stuck. The SystemC kernel elaborates once per process, so call this once per process.
RunStatistics simulate(DataflowAccelerator& accelerator, SimulationOptions const& options = {});

}  // namespace dataflow
