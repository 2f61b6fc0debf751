#pragma once
#include <string>
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/html/packed_timeline.hpp"

namespace dataflow::report {

/// Who waits for whom, as in summary.json, and what could be `deeper`: the FIFOs of the circle that are full, with the
/// keys of their depths.
Json deadlock_data(RunStatistics const& run);

/// What ran it.
struct RunCommand {
    std::string words;                  ///< without settings
    std::vector<std::string> settings;  ///< KEY=VALUE
};

/// A timeline that ends with a deadlock, and the waits that do not end as stalls up to there.
SampleTimeline with_endless_waits(SampleTimeline timeline, RunStatistics const& run);

/// One HTML page of a run that got stuck, which needs nothing else. `timelines`: of its unfinished samples; may be
/// none.
std::string deadlock_html(std::string const& title, RunCommand const& command, RunStatistics const& run,
                          std::vector<ResolvedKey> const& keys, std::vector<PackedTimeline> const& timelines);

}  // namespace dataflow::report
