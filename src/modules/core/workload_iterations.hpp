#pragma once
#include "channels/simulated_design.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Each sample clears, compares and reads out its window, one pixel as the other, and scans the boxes around its
/// triangles, of which some are looked at.
LoopIterations loop_iterations(Stimulus const& stimulus);
/// The iterations of so many samples of an object that is in none yet, as if it filled the window.
LoopIterations loop_iterations(Stimulus const& observed, std::size_t samples);

}  // namespace faster
