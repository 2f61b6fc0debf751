#pragma once
#include <functional>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/figures/sensitivity.hpp"
#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow::replay {

/// The exact change of total_cycles for one step of each of timing_keys(), by retiming a recorded run of `loaded`, one
/// row per key in their order. On all host cores; `progress` is told how many of `steps` retimings are done, from any
/// of them but one at a time.
std::vector<Sensitivity> sensitivities(RecordedRun const& run, LoadedConfig const& loaded,
                                       std::function<void(std::size_t done, std::size_t steps)> const& progress = {});

/// What every other value of each choice about the whole machine changes; values with which the machine stays what it
/// is are left out.
std::vector<Alternative> alternatives(RecordedRun const& run, LoadedConfig const& loaded);

}  // namespace dataflow::replay
