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

struct TestRun {
    RunStatistics statistics;
    std::vector<SampleMaps> maps;  ///< one per sample if asked for, else empty; of a deadlocked run some are empty
};

struct TestRunOptions {
    bool with_maps = false;
    bool critical_path = false;
    bool sensitivities = false;
    bool hazards = false;
    std::filesystem::path events{};  ///< event file to be written, unless the run deadlocks; empty: none
    std::size_t trail_length = timing::Trail::usual_length;
    std::vector<Recording> recordings{};
    SampleProbe* probe = nullptr;  ///< sees the maps, instead of with_maps; may be null
};

/// simulate() with a kernel of its own, so that a test can run as many designs as it wants.
TestRun test_run(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                 TestRunOptions const& options = {});

}  // namespace faster::testing
