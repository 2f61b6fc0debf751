#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/stimulus.hpp"
#include "kernel/config/load_config.hpp"
#include "tool/recording_options.hpp"

namespace faster {

/// What an iteration scored, and what its scores were.
struct ScoredPoses {
    std::vector<Pose> poses;
    std::vector<SampleCounters> counters;
};

/// Cycles of all iterations, or what went wrong.
struct IterationCycles {
    std::vector<std::uint64_t> cycles;
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
IterationCycles simulate_iterations(LoadedConfig const& loaded, Stimulus const& observed,
                                    std::vector<ScoredPoses> const& iterations,
                                    std::optional<IterationRecording> const& recording, std::size_t jobs);

}  // namespace faster
