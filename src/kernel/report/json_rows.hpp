#pragma once
#include <cstddef>

#include "kernel/base/json.hpp"
#include "kernel/figures/run_statistics.hpp"

namespace faster::report {

/// Rows of the tables of a run as JSON objects; `i` is the number of the ModuleId, FifoId or LoopId.
Json module_row(std::size_t core, std::size_t i, ProcessStatistics const& p);
Json fifo_row(std::size_t core, std::size_t i, FifoStatistics const& f);
Json loop_row(std::size_t core, std::size_t i, LoopStatistics const& l);

}  // namespace faster::report
