#pragma once
#include <cstdint>

namespace dataflow::timing {

/// What states and phrases are recognized by: 128 bits, so that two that differ are hardly ever taken for the same.
struct Print {
    std::uint64_t first = 0;
    std::uint64_t second = 0;

    bool operator==(Print const& other) const { return first == other.first && second == other.second; }
};

}  // namespace dataflow::timing
