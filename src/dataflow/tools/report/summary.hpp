#pragma once
#include <string>
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// What the host spent; kept apart from simulated figures, so that those compare equal from run to run.
struct HostTime {
    double build_seconds = 0;  ///< reading or making the workload
    double simulate_seconds = 0;
};

/// summary.json (docs/formats.md#summaryjson): resolved configuration, totals, and per-module, per-FIFO, per-BRAM,
/// per-loop tables. `made_by`: of made_by_json(); null leaves it out, for what is to be the same whatever the command.
std::string summary_json(std::vector<ResolvedKey> const& keys, RunStatistics const& run, HostTime const& host,
                         Json const& made_by = {});

/// Who waits for whom in a run that got stuck.
Json deadlock_json(RunStatistics const& run);

/// summary.json of a run that got stuck: who waits for whom, and the configuration. Its figures are
/// those until then.
std::string deadlock_summary_json(std::vector<ResolvedKey> const& keys, RunStatistics const& run,
                                  Json const& made_by = {});

}  // namespace dataflow::report
