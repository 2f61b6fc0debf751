#pragma once
#include <functional>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/figures/sensitivity.hpp"
#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow::replay {

/// The largest change of a key that is tried.
constexpr std::int64_t most_slack = 1024;

/// Adds to each step of `rows`, the sensitivities() of a recorded run of `loaded`, the largest change in its direction
/// that costs nothing: with which the run takes `total_cycles` or fewer. The change itself is retimed, and one more,
/// which costs, is too; what lies between is found by doubling and bisection, and assumes that more of a change never
/// costs less. `progress` as for sensitivities(); how many probes there will be is not known before.
void find_slack(RecordedRun const& run, LoadedConfig const& loaded, Cycles total_cycles, std::vector<Sensitivity>& rows,
                std::function<void(std::size_t done, std::size_t steps)> const& progress = {});

}  // namespace dataflow::replay
