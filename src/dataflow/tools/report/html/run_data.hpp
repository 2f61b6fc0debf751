#pragma once
#include <vector>

#include "dataflow/base/json.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// All keys as pages show them. Values as text: JavaScript's numbers would round the larger integers.
Json configuration_data(std::vector<ResolvedKey> const& keys);

/// Parts of what pages draw of a run.

Json headline_data(RunStatistics const& run);
/// Names of the classes of cycles and of the causes of a critical path that a machine can have.
Json cycle_class_data(Machine const& machine);
Json path_cause_data(Machine const& machine);
/// Where the cycles of the modules went, all cores together, by the classes of a machine that has no fewer.
Json module_data(RunStatistics const& run, Machine const& classes);
/// What held the modules up: a row per module and FIFO or block RAM that cost it cycles.
Json stall_data(RunStatistics const& run);

}  // namespace dataflow::report
