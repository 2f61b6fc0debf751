#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>

namespace dataflow {

/// Words and bits of a block RAM primitive in one of its shapes.
struct PrimitiveShape {
    std::uint64_t words;
    std::uint64_t bits;
};

constexpr std::uint64_t divided_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// Primitives for `words` words of `bits` bits, in the shape that takes fewest.
template <class Shapes> std::uint64_t fewest(std::uint64_t words, std::uint64_t bits, Shapes const& shapes) {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (PrimitiveShape const& shape : shapes)
        least = std::min(least, divided_up(words, shape.words) * divided_up(bits, shape.bits));
    return least;
}

}  // namespace dataflow
