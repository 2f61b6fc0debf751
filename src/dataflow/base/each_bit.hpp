#pragma once
#include <cstdint>

namespace dataflow {

/// Calls `visit` with the number of each bit that is set, from the lowest up.
template <class Visit> void for_each_bit(std::uint32_t mask, Visit visit) {
    for (; mask != 0; mask &= mask - 1)
        visit(static_cast<unsigned>(__builtin_ctz(mask)));
}

/// Calls `visit` with the number of the first bit of each run of bits that are set, and with one behind its last.
template <class Visit> void for_each_run(std::uint32_t mask, Visit visit) {
    while (mask != 0) {
        auto const first = static_cast<unsigned>(__builtin_ctz(mask));
        auto const end = first + static_cast<unsigned>(__builtin_ctzll(~(std::uint64_t{mask} >> first)));
        visit(first, end);
        mask &= static_cast<std::uint32_t>(~std::uint64_t{0} << end);
    }
}

}  // namespace dataflow
