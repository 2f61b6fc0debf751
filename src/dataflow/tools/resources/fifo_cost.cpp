#include "dataflow/tools/resources/fifo_cost.hpp"

#include <algorithm>
#include <array>

#include "dataflow/base/device/primitive_shapes.hpp"
#include "dataflow/base/integer_bits.hpp"

namespace dataflow {

namespace {

/// Simple dual port.
constexpr std::array<PrimitiveShape, 6> simple_ramb18_shapes{
    {{16384, 1}, {8192, 2}, {4096, 4}, {2048, 9}, {1024, 18}, {512, 36}}};
constexpr std::array<PrimitiveShape, 7> simple_ramb36_shapes{
    {{32768, 1}, {16384, 2}, {8192, 4}, {4096, 9}, {2048, 18}, {1024, 36}, {512, 72}}};

Primitives shift_register(std::uint64_t depth, std::uint64_t bits) {
    return {depth <= 16 ? divided_up(bits, 2) : bits * divided_up(depth, 32), 0};
}

Primitives distributed_ram(std::uint64_t depth, std::uint64_t bits) {
    std::uint64_t const data = depth <= 32 ? divided_up(bits, 2) : bits;
    std::uint64_t const write_addresses = divided_up(data, 7);
    return {(data + write_addresses) * divided_up(depth, 64), 0};
}

/// Halves of RAMB36: whichever size takes less.
Primitives block_ram(std::uint64_t depth, std::uint64_t bits) {
    return {0, std::min(fewest(depth, bits, simple_ramb18_shapes), 2 * fewest(depth, bits, simple_ramb36_shapes))};
}

/// LUTs for each bit.
std::uint64_t multiplexers_of(std::uint64_t depth) {
    std::uint64_t luts = 0;
    for (std::uint64_t inputs = divided_up(depth, 128); inputs > 1;) {
        inputs = divided_up(inputs, 4);
        luts += inputs;
    }
    return luts;
}

}  // namespace

double cost_of(Primitives const& primitives, CostWeights const& weights) {
    return static_cast<double>(primitives.luts) + static_cast<double>(primitives.ramb18) / 2 * weights.luts_per_ramb36;
}

Primitives primitives_of(FifoKind kind, std::uint64_t depth, unsigned bits, CostWeights const& weights) {
    if (kind == FifoKind::shift_register)
        return shift_register(depth, bits);
    Primitives const distributed = distributed_ram(depth, bits);
    Primitives const block = block_ram(depth, bits);
    return cost_of(block, weights) < cost_of(distributed, weights) ? block : distributed;
}

Resources counted_fifo(FifoKind kind, std::uint64_t tokens, std::uint64_t capacity, unsigned bits) {
    Primitives const primitives = primitives_of(kind, tokens, bits, {});
    double const count = bits_for(capacity);
    Resources fifo{static_cast<double>(primitives.luts) + 2 * count, count, 0,
                   static_cast<double>(primitives.ramb18) / 2};
    if (kind == FifoKind::shift_register)
        fifo.lut += static_cast<double>(bits * multiplexers_of(tokens));
    else  // two addresses, the output register and its valid bit
        fifo += {2 * count, 2 * count + bits + 1, 0, 0};
    return fifo;
}

}  // namespace dataflow
