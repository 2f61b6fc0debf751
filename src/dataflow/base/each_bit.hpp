#pragma once
#include <cstdint>

namespace dataflow {

/// Calls `visit` with the number of each bit that is set, from the lowest up.
template <class Visit> void for_each_bit(std::uint32_t mask, Visit visit) {
    for (; mask != 0; mask &= mask - 1)
        visit(static_cast<unsigned>(__builtin_ctz(mask)));
}

}  // namespace dataflow
