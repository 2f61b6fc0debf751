#pragma once
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// Checks all figures of both engines against each other and against the cycle twin, or how they got stuck. False: they
/// deadlocked.
bool check_agreement(AcceleratorConfig const& config, Stimulus const& stimulus);

/// Checks that a recorded run, retimed, has all figures of a run of this configuration, which it returns.
RunStatistics check_retiming(replay::RecordedRun const& recorded, AcceleratorConfig const& config,
                             Stimulus const& stimulus);

}  // namespace faster::testing
