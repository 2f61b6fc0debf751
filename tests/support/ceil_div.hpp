#pragma once
#include <cstdint>

namespace faster::testing {

/// The least integer that is no less than the quotient.
inline std::uint64_t ceil_div(std::uint64_t dividend, std::uint64_t divisor) {
    return (dividend + divisor - 1) / divisor;
}

}  // namespace faster::testing
