#pragma once
#include <optional>

#include "channels/simulate.hpp"

namespace dataflow {

/// A run whose cores share nothing, in several processes of the host, each of which has some of the cores. Nothing if
/// it cannot be had so: if SimulationOptions do not let it, if there is no further process, or if one does not come to
/// the end of its samples. Nothing has happened to the accelerator then.
std::optional<RunStatistics> simulate_in_parts(DataflowAccelerator& accelerator, SimulationOptions const& options);

}  // namespace dataflow
