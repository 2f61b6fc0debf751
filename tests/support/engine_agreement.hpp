#pragma once
#include "common/stimulus.hpp"
#include "faster/accelerator_config.hpp"

namespace faster::testing {

/// Checks all figures of both engines against each other and against the cycle twin, or how they got stuck. False: they
/// deadlocked.
bool check_agreement(AcceleratorConfig const& config, Stimulus const& stimulus);

}  // namespace faster::testing
