#pragma once
#include <string>

#include "dataflow/run/config/run_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// The tables samples.csv, fifos.csv and loops.csv (docs/formats.md#output-of-a-run), header line first.
/// `config`: of the run; a run without samples has its counters as columns.
std::string samples_csv(RunStatistics const& run, RunConfig const& config);
std::string fifos_csv(RunStatistics const& run);
std::string loops_csv(RunStatistics const& run);

/// loops.csv with the loops that the design leaves out of it: the rows of loops.csv first.
std::string all_loops_csv(RunStatistics const& run);

}  // namespace dataflow::report
