#pragma once
#include "dataflow/run/figures/module_row.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/figures/table_columns.hpp"

namespace dataflow {

/// Rows of the tables of a run, core by core, in the order of the output files.
std::vector<ModuleRow> module_rows(RunStatistics const& run);
std::vector<FifoRow> fifo_rows(RunStatistics const& run);
std::vector<LoopRow> loop_rows(RunStatistics const& run);
std::vector<MemoryRow> memory_rows(RunStatistics const& run);
/// Of the loops whose accesses were looked after; and all cores together.
std::vector<DependenceRow> dependence_rows(RunStatistics const& run);
std::vector<DependenceRow> dependence_sums(RunStatistics const& run);

/// Modules of all cores together.
std::vector<ModuleRow> module_sums(RunStatistics const& run);

}  // namespace dataflow
