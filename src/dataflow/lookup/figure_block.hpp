#pragma once
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "dataflow/base/uninitialized.hpp"

namespace dataflow::timing {

/// What a transition adds to the figures of a loop or a FIFO that only grow: three are summed up, of one only the
/// largest counts. Which they are, and of whom: see RelativeState::blocks_of().
struct FigureBlock {
    std::array<std::uint32_t, 3> sums;
    std::uint16_t largest;
    std::uint16_t number;

    static FigureBlock none(std::uint16_t number) { return {{0, 0, 0}, 0, number}; }
};
static_assert(sizeof(FigureBlock) == 16 && std::is_trivial_v<FigureBlock>, "is copied all at once, and often");

using FigureBlocks = std::vector<FigureBlock, Uninitialized<FigureBlock>>;

/// The figures of many transitions, added up.
struct FigureTotal {
    std::array<std::uint64_t, 3> sums{};
    std::uint64_t largest = 0;
};
using FigureTotals = std::vector<FigureTotal>;  ///< by number

}  // namespace dataflow::timing
