#pragma once
#include <cstdint>

namespace dataflow {

/// A point in, or a length of, simulated time, in clock cycles. Cycle 0 is the first one
/// (docs/timing-model.md#vocabulary).
using Cycles = std::uint64_t;

/// Simulated time where clocks of several periods meet. 64 bits hold seven months, which is not enough for a run at a
/// kilohertz.
__extension__ using Picoseconds = unsigned __int128;

}  // namespace dataflow
