#pragma once
#include <string>

#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/json_rows.hpp"

namespace dataflow::report {

/// The loops whose iterations write what later ones read, with their hazards, all cores together: lines of text, empty
/// if nobody has looked.
std::string hazards_text(RunStatistics const& run);

/// `hazards` of summary.json (docs/formats.md): a row per core, loop and block RAM.
Json hazards_json(RunStatistics const& run);
/// A row per loop and block RAM, all cores together, without `core`.
Json hazard_sums_json(RunStatistics const& run);

}  // namespace dataflow::report
