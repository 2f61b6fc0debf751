#pragma once
#include <string>

#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/json_rows.hpp"

namespace dataflow::report {

/// The keys whose steps change total_cycles, those that save most first: lines of text, empty if none were worked out.
/// Then, if it was looked for, what slack keys have.
std::string sensitivities_text(RunStatistics const& run);

/// sensitivities.csv and `sensitivities` of summary.json (docs/formats.md): a row per key and step, in the order of the
/// keys.
std::string sensitivities_csv(RunStatistics const& run);
Json sensitivities_json(RunStatistics const& run);
Json alternatives_json(RunStatistics const& run);
/// Sensitivities and alternatives as the file of `faster-sim sensitivities --json`.
std::string sensitivities_file_json(RunStatistics const& run);

}  // namespace dataflow::report
