#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/stimulus.hpp"
#include "kernel/config/load_config.hpp"
#include "kernel/machine/path_table.hpp"
#include "tool/recording_options.hpp"

namespace faster {

/// What an iteration scored, and what its scores were.
struct ScoredPoses {
    std::vector<Pose> poses;
    std::vector<SampleCounters> counters;
};

/// What an iteration costs on the accelerator.
struct IterationCost {
    std::uint64_t cycles = 0;
    Estimate energy_mj;  ///< of these cycles
    Estimate idle_w;     ///< while the accelerator waits for the host
};

/// Of all iterations, or what went wrong.
struct IterationCosts {
    std::vector<IterationCost> costs;
    std::string deadlock;  ///< the report of the first that got stuck; empty if none
};

/// What of which iteration is to be recorded.
struct IterationRecording {
    std::uint64_t iteration = 0;
    std::string events;  ///< file; empty: none
    RecordingRequest request;
    bool force = false;  ///< even a waveform of more than 2 GB
};

/// Simulates every iteration on the configured accelerator, each in a process of its own, as the SystemC kernel
/// elaborates once; `jobs` at once. A model whose counters are not those that the loop went by is a std::runtime_error.
/// Throws InputError for a recording that cannot be written, and for a simulation that crashes.
IterationCosts simulate_iterations(LoadedConfig const& loaded, Stimulus const& observed,
                                   std::vector<ScoredPoses> const& iterations,
                                   std::optional<IterationRecording> const& recording, std::size_t jobs);

}  // namespace faster
