#pragma once
#include <cstdint>

namespace dataflow {

/// One memory of a core, as its users see it.
struct MemoryShape {
    std::uint64_t words = 0;
    std::uint64_t bits = 0;        ///< per word; 0: there is no such memory
    std::uint64_t ports = 2;       ///< accesses per cycle, of all banks together
    std::uint64_t partition = 1;   ///< banks that share the words
    std::uint64_t bank_words = 0;  ///< of the largest bank; 0: they share evenly
    std::uint64_t buffers = 1;     ///< how often all of this is there
    double share = 1;              ///< of all this that is a core's, if several share it
};

/// How many block RAMs of 36 Kbit a memory takes on an UltraScale+ device; a RAMB18 is half of one.
///
/// Every bank is laid out in one of the primitive's true dual-port shapes, the one that takes fewest; a bank for which
/// one RAMB18 is enough takes that, any other whole RAMB36. A primitive has two ports: where the banks together have
/// fewer than `ports`, the whole memory is there several times. Each buffer is a memory of its own. Source: AMD UG573.
double ramb36_count(MemoryShape const& memory);
/// That the ZCU102's XCZU9EG has.
constexpr double ramb36_of_device = 912;

}  // namespace dataflow
