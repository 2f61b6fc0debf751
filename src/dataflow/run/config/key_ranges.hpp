#pragma once
#include "dataflow/run/config/key.hpp"

namespace dataflow {

// What keys of a machine may say, and so the defaults of a description.

constexpr IntegerRange cycles_range{1, 1'000'000};      ///< depths and intervals of loops, setups
constexpr IntegerRange stages_range{0, 1'000'000};      ///< stages of accesses, states around loops
constexpr IntegerRange fifo_depth_range{1, 1'048'576};  ///< tokens
constexpr IntegerRange buffers_range{1, 1024};          ///< of a ping-pong buffer

}  // namespace dataflow
