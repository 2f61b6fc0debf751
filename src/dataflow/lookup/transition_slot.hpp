#pragma once
#include <cstdint>

#include "dataflow/phrases/print.hpp"

namespace dataflow::timing {

/// All of a known transition that is looked at every time, in half a cache line. Its print is that of state and phrase.
struct alignas(32) TransitionSlot {
    using Number = std::uint32_t;
    static constexpr Number none = ~Number{0};

    Print print{0, 0};
    Number number = none;
    Number next = none;        ///< state after the transition
    std::uint32_t cycles = 0;  ///< that it takes
    std::uint8_t entered = 0;  ///< members that entered a loop, a bit each
    bool notable = false;      ///< something besides time to take down

    std::uint64_t hash() const { return print.first; }
};

}  // namespace dataflow::timing
