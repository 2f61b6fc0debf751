#pragma once
#include <string>

#include "kernel/base/json.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// The external memory of a run, for people and for summary.json. Empty, or null, if it is ideal.
std::string memory_traffic_text(RunStatistics const& run);
Json memory_traffic_json(RunStatistics const& run);

}  // namespace faster::report
