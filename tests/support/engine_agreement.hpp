#pragma once
#include "common/stimulus.hpp"
#include "faster/accelerator_config.hpp"
#include "kernel/figures/run_statistics.hpp"
#include "kernel/replay/recorded_run.hpp"

namespace faster::testing {

/// Checks all figures of both engines against each other and against the cycle twin, or how they got stuck. False: they
/// deadlocked.
bool check_agreement(AcceleratorConfig const& config, Stimulus const& stimulus);

/// Checks that a recorded run, retimed, has all figures of a run of this configuration, which it returns.
RunStatistics check_retiming(replay::RecordedRun const& recorded, AcceleratorConfig const& config,
                             Stimulus const& stimulus);

}  // namespace faster::testing
