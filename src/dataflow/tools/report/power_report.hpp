#pragma once
#include <string>

#include "dataflow/base/json.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// What a run burns, estimated as a range, for people and for summary.json. Empty, or null, for a run without cycles,
/// and for a design that tells nothing of its modules.
std::string power_text(RunStatistics const& run);
Json power_json(RunStatistics const& run);

}  // namespace dataflow::report
