#pragma once
#include <string>

#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// The tables of SPEC section 4, header line first, as they stand in samples.csv, fifos.csv and loops.csv.
std::string samples_csv(RunStatistics const& run);
std::string fifos_csv(RunStatistics const& run);
std::string loops_csv(RunStatistics const& run);

/// loops.csv with the loops that SPEC section 4 leaves out of it: the rows of loops.csv first.
std::string all_loops_csv(RunStatistics const& run);

}  // namespace dataflow::report
