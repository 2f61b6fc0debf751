#pragma once
#include <filesystem>
#include <vector>

#include "dataflow/core/time/trail.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/faster_simulation.hpp"

namespace faster::testing {

struct ForkedRun {
    RunStatistics statistics;
    std::vector<SampleMaps> maps;  ///< one per sample if asked for, else empty; of a deadlocked run some are empty
};

struct ForkOptions {
    bool with_maps = false;
    bool critical_path = false;
    bool sensitivities = false;
    bool hazards = false;
    std::filesystem::path events{};  ///< event file to be written, unless the run deadlocks; empty: none
    std::size_t trail_length = timing::Trail::usual_length;
    std::vector<Recording> recordings{};  ///< handed over in the child: they can tell by throwing
    SampleProbe* probe = nullptr;         ///< sees the maps in the child, instead of with_maps; may be null
};

/// simulate() in a child process, because the SystemC kernel elaborates once per process. Throws std::runtime_error
/// with the reason if the child throws, crashes or takes longer than two minutes.
ForkedRun run_forked(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                     ForkOptions const& options = {});

}  // namespace faster::testing
