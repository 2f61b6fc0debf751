#pragma once
#include <cstdint>

#include "dataflow/base/device/resources.hpp"
#include "dataflow/core/machine/fifo_kind.hpp"

namespace dataflow {

/// What a FIFO's tokens are kept in, on an UltraScale+ device. Counters, flags, multiplexers and output registers are
/// not counted.
struct Primitives {
    std::uint64_t luts = 0;    ///< look-up tables of SLICEMs, as shift registers or as distributed RAM
    std::uint64_t ramb18 = 0;  ///< block RAMs of 18 Kbit; two are a RAMB36

    bool operator==(Primitives const& other) const { return luts == other.luts && ramb18 == other.ramb18; }
};

/// What one thing is worth in another, so that costs can be compared.
struct CostWeights {
    /// LUTs that a RAMB36 is worth: by default as many as the ZCU102's XCZU9EG has for each.
    double luts_per_ramb36 = xczu9eg.has.lut / xczu9eg.has.ramb36;
};

/// Below it costs are the same [LUTs]: they are sums of a few hundred thousand at most.
constexpr double cost_rounding = 1e-6;

/// In LUTs.
double cost_of(Primitives const& primitives, CostWeights const& weights);

/// The primitives for `depth` tokens of `bits` bits each, in a FIFO of a kind that is resolved.
///
/// A shift register takes an SRL16 (half a LUT) per bit up to depth 16, above an SRLC32E (a LUT) per bit and 32 tokens.
/// A memory takes distributed RAM or block RAM, whichever costs less. Distributed RAM, simple dual port: up to depth 32
/// two bits per LUT, above 64 words of a bit per LUT, and a LUT for the write address with every seven. Block RAM: the
/// shape of RAMB18 or RAMB36 that takes fewest, simple dual port shapes of 512 words included.
/// Source: AMD UG574 (SLICEM), UG573 (block RAM).
Primitives primitives_of(FifoKind kind, std::uint64_t depth, unsigned bits, CostWeights const& weights);

/// A whole FIFO of a kind that is resolved: its primitives, a counter that reaches `capacity`, a memory's addresses and
/// output register, a long shift register's multiplexers. Four SRLC32E join for nothing (MUXF7, MUXF8); of such fours a
/// LUT per bit picks one in four, and so on until one is left.
Resources counted_fifo(FifoKind kind, std::uint64_t tokens, std::uint64_t capacity, unsigned bits);

}  // namespace dataflow
