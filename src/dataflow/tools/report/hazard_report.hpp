#pragma once
#include <string>

#include "kernel/figures/run_statistics.hpp"
#include "kernel/report/json_rows.hpp"

namespace faster::report {

/// The loops whose iterations write what later ones read, with their hazards, all cores together: lines of text, empty
/// if nobody has looked.
std::string hazards_text(RunStatistics const& run);

/// `hazards` of summary.json (docs/formats.md): a row per core, loop and block RAM.
Json hazards_json(RunStatistics const& run);
/// The same of all cores together, without `core`.
Json hazard_sums_json(RunStatistics const& run);

}  // namespace faster::report
