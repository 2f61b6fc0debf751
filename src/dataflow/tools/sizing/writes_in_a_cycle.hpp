#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow::sizing {

/// By FIFO, how many tokens its writer may write in one cycle: more than one where steps outside loops follow each
/// other without taking time (docs/timing-model.md#fifos). No FIFO's depth changes that; a bound, of at least 1.
std::vector<std::uint64_t> writes_in_a_cycle(replay::RecordedRun const& run);

}  // namespace dataflow::sizing
