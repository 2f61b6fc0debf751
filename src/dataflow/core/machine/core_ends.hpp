#pragma once
#include <optional>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/time/core_timing.hpp"

namespace dataflow {

/// When the samples of a core began. One process alone begins a sample with its next call.
std::vector<Cycles> sample_begins(Machine const& machine, timing::CoreTiming const& core);
/// When those that are done ended: their last cycles.
std::vector<Cycles> const& sample_ends(Machine const& machine, timing::CoreTiming const& core);

/// The last cycle of a core's run, and the process whose it is: of several, the first.
struct RunEnd {
    std::size_t process = 0;
    Cycles cycle = 0;
};
/// So far; none if no process has done anything, or no sample has ended where that ends the run.
std::optional<RunEnd> run_end(Machine const& machine, timing::CoreTiming const& core);

}  // namespace dataflow
