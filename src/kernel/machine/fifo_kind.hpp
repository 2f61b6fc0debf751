#pragma once
#include <cstdint>

#include "kernel/base/cycles.hpp"

namespace faster {

/// How a FIFO is built (SPEC section 3): decides its capacity and read latency.
enum class FifoKind { automatic, shift_register, memory };

/// What a flushing pipeline does whose FIFO is full (SPEC section 3, AreaReciprocal): freeze with its bubbles, or let
/// its tokens close up, as stages that each take a token whenever they are empty do.
enum class WhenFull { freeze, squeeze };

/// A kind with `automatic` decided: shift register up to depth 2, memory above.
constexpr FifoKind resolved_kind(FifoKind kind, std::uint64_t depth) {
    if (kind != FifoKind::automatic)
        return kind;
    return depth <= 2 ? FifoKind::shift_register : FifoKind::memory;
}

/// Tokens that fit into a FIFO of a resolved kind: a memory has an output register besides.
constexpr std::uint64_t capacity_of(FifoKind resolved, std::uint64_t depth) {
    return resolved == FifoKind::memory ? depth + 1 : depth;
}

/// A token written in cycle s can be read from s + this on.
constexpr Cycles read_latency_of(FifoKind resolved) { return resolved == FifoKind::memory ? 2 : 1; }

}  // namespace faster
