#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tb/estimate_scene.hpp"
#include "tool/recording_options.hpp"
#include "tool/subcommand.hpp"

namespace faster {

/// `faster-sim estimate`.
struct EstimateRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;                      ///< folder; empty: print only
    std::string backend;                  ///< stands for estimator.backend; empty: as configured
    std::vector<std::uint64_t> pictures;  ///< iterations to draw; empty: a choice of them
    std::vector<std::uint64_t> traces;    ///< iterations to write as stimulus traces
    std::int64_t jobs = 0;                ///< threads and processes; 0: the host's cores
    BopRequest bop;                       ///< instead of the configured workload
    bool untimed = false;                 ///< without the accelerator's cycles
    std::uint64_t recorded_iteration = 0;
    std::string events;          ///< file of that iteration's events; empty: none
    RecordingRequest recording;  ///< of that iteration
    bool force = false;          ///< however long it takes, and even a waveform of more than 2 GB

    bool records() const { return !events.empty() || recording.has_waveform() || !recording.timeline.empty(); }
};

/// Looks for an object's pose by the thesis's second stage. Throws InputError on bad input. Exit code 3 if the
/// accelerator deadlocks.
int estimate_pose(EstimateRequest const& request);

/// `estimate`.
Subcommand estimate_command();

}  // namespace faster
