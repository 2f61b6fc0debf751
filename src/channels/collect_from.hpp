#pragma once
#include <cstddef>

#include "channels/dataflow_accelerator.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow {

/// The figures of cores [first, end) of a run that has come to its end, or is stuck; as numbers of cores, the first is
/// 0. `others`: cycles that the other cores take.
RunStatistics collect_from(DataflowAccelerator& accelerator, std::size_t first, std::size_t end, Cycles others = 0);

}  // namespace dataflow
