#pragma once
#include <cstdint>

namespace dataflow {

/// A point in, or a length of, simulated time, in clock cycles. Cycle 0 is the first one
/// (docs/timing-model.md#vocabulary).
using Cycles = std::uint64_t;

}  // namespace dataflow
