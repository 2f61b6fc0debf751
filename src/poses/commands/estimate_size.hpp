#pragma once
#include <cstddef>

#include "channels/simulated_design.hpp"
#include "dataflow/run/config/run_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// How long scoring takes one thread of the host [s], as far as that can be said beforehand (WorkSize).

/// By GRIP, so many poses of an object in the image of `observed`.
double seconds_by_grip(Stimulus const& observed, std::size_t poses);
/// By the untimed reference.
double seconds_by_reference(LoopIterations const& iterations);
/// A whole estimate. `timed`: the cycles of its iterations are simulated, too.
double seconds_of_estimate(RunConfig const& config, Stimulus const& observed, bool timed);

}  // namespace faster
