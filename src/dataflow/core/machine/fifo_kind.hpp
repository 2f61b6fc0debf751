#pragma once
#include <cstdint>

#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// How a FIFO is built (docs/timing-model.md#fifos): decides its capacity and read latency.
enum class FifoKind { automatic, shift_register, memory };

/// What a flushing pipeline does whose FIFO is full (docs/timing-model.md#a-flushing-pipeline-that-freezes): freeze
/// with its bubbles, or let its tokens close up, as stages that each take a token whenever they are empty do.
enum class WhenFull { freeze, squeeze };

/// Whose FIFOs a machine has; key `accelerator.fifo_rules` (docs/timing-model.md#fifos). The generations differ in what
/// `automatic` becomes, and in whether a memory's output register holds a token besides the memory's words.
enum class FifoGeneration {
    spec,        ///< a memory from depth 3 on; no tool's
    vivado_hls,  ///< Vivado HLS
    vitis_hls,   ///< Vitis HLS, from 2020.1 on
};

/// The largest that HLS builds of shift registers where it is free to choose: `auto_srl_max_depth` and
/// `auto_srl_max_bits` of its `config_storage`, as they are by default. One of the two is enough.
constexpr std::uint64_t auto_shift_register_depth = 2;    ///< tokens
constexpr std::uint64_t auto_shift_register_bits = 1024;  ///< depth times bits of a token

/// A kind with `automatic` decided. `bits`: of a token.
constexpr FifoKind resolved_kind(FifoKind kind, std::uint64_t depth, unsigned bits, FifoGeneration generation) {
    if (kind != FifoKind::automatic)
        return kind;
    bool const is_small = generation != FifoGeneration::spec && depth * bits <= auto_shift_register_bits;
    return depth <= auto_shift_register_depth || is_small ? FifoKind::shift_register : FifoKind::memory;
}

/// Tokens that a FIFO of a resolved kind holds beyond its depth: in a memory's output register.
constexpr std::uint64_t tokens_beyond_depth(FifoKind resolved, FifoGeneration generation) {
    return resolved == FifoKind::memory && generation != FifoGeneration::vitis_hls ? 1 : 0;
}

/// A token written in cycle s can be read from s + this on.
constexpr Cycles read_latency_of(FifoKind resolved) { return resolved == FifoKind::memory ? 2 : 1; }

}  // namespace dataflow
