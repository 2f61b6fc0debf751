#pragma once
#include <string>

#include "kernel/base/json.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// What a run burns, estimated as a range, for people and for summary.json. Empty, or null, for a run without cycles,
/// and for a design that tells nothing of its modules.
std::string power_text(RunStatistics const& run);
Json power_json(RunStatistics const& run);

}  // namespace faster::report
