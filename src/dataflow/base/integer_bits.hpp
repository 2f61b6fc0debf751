#pragma once
#include <cstdint>

namespace dataflow {

/// Bits of the numbers from 0 to the largest; none for 0.
constexpr unsigned bits_for(std::uint64_t largest) {
    unsigned bits = 0;
    for (; largest > 0; largest /= 2)
        ++bits;
    return bits;
}

/// 0 counts as one.
constexpr bool is_power_of_two(std::uint64_t number) { return (number & (number - 1)) == 0; }

}  // namespace dataflow
