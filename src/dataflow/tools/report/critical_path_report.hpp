#pragma once
#include <string>

#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/json_rows.hpp"

namespace dataflow::report {

/// The critical path of a run for people, the largest rows first: lines of text, empty if it was not traced.
std::string critical_path_text(RunStatistics const& run);

/// `critical_path` of summary.json (docs/formats.md); the run's must have been traced.
Json critical_path_json(RunStatistics const& run);

}  // namespace dataflow::report
