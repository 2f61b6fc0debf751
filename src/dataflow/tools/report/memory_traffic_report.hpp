#pragma once
#include <string>

#include "dataflow/base/json.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// The external memory of a run, for people and for summary.json. Empty, or null, if it is ideal.
std::string memory_traffic_text(RunStatistics const& run);
Json memory_traffic_json(RunStatistics const& run);

}  // namespace dataflow::report
