#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "dataflow/commands/recording_options.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/tools/resources/path_table.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

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

/// The accelerator got stuck in an iteration; what() is the report.
class DeadlockedIteration : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What of which iteration is to be recorded.
struct IterationRecording {
    std::uint64_t iteration = 0;
    std::string events;  ///< file; empty: none
    RecordingRequest request;
    bool force = false;  ///< even a waveform of more than 2 GB
};

/// What a simulated iteration counted, and what it cost.
struct SimulatedIteration {
    std::vector<SampleCounters> counters;
    IterationCost cost;
};

/// Simulates the samples of a stimulus on the configured accelerator, in a process of its own, as the SystemC kernel
/// elaborates once. `number` is for messages. Throws DeadlockedIteration, and HostError for a simulation that crashes.
SimulatedIteration simulate_iteration(LoadedConfig const& loaded, Stimulus const& stimulus, std::size_t number);

/// Simulates every iteration, `jobs` at once: what each costs. A model whose counters are not those that the loop
/// went by is a std::runtime_error. Throws also InputError for a recording that cannot be written.
std::vector<IterationCost> simulate_iterations(LoadedConfig const& loaded, Stimulus const& observed,
                                               std::vector<ScoredPoses> const& iterations,
                                               std::optional<IterationRecording> const& recording, std::size_t jobs);

}  // namespace faster
