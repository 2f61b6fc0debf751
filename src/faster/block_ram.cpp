#include "faster/block_ram.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "faster/edge_map_design.hpp"
#include "faster/extract_design.hpp"
#include "faster/lane_rows.hpp"
#include "faster/sweep_design.hpp"
#include "kernel/machine/bank_partition.hpp"

namespace faster {
namespace {

constexpr std::uint64_t ports_per_primitive = 2;
constexpr std::uint64_t depth_bits = 11;

/// Words and bits of a primitive in one of its shapes.
struct PrimitiveShape {
    std::uint64_t words;
    std::uint64_t bits;
};

constexpr std::array<PrimitiveShape, 6> ramb36_shapes{
    {{32768, 1}, {16384, 2}, {8192, 4}, {4096, 9}, {2048, 18}, {1024, 36}}};
constexpr std::array<PrimitiveShape, 5> ramb18_shapes{{{16384, 1}, {8192, 2}, {4096, 4}, {2048, 9}, {1024, 18}}};

constexpr std::uint64_t divided_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// Primitives for one bank in the shape that takes fewest.
template <class Shapes> std::uint64_t fewest(std::uint64_t words, std::uint64_t bits, Shapes const& shapes) {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (PrimitiveShape const& shape : shapes) {
        least = std::min(least, divided_up(words, shape.words) * divided_up(bits, shape.bits));
    }
    return least;
}

double ramb36_of_bank(std::uint64_t words, std::uint64_t bits) {
    return fewest(words, bits, ramb18_shapes) == 1 ? 0.5 : static_cast<double>(fewest(words, bits, ramb36_shapes));
}

/// Thesis A.2 (u1), 5.1 (u2); A.3 with SPEC section 2 (u11).
std::uint64_t bits_of(BramId id, AcceleratorConfig const& config) {
    bool const extracts = config.flow == Flow::fpga_grip;
    PerMap const bits = extracts ? PerMap{} : design_of(config.edge_map.algorithm).bits;
    switch (id) {
        case BramId::edge_map:
            return bits.edge_map;
        case BramId::object_map:
            return bits.object_map;
        case BramId::depth_buffer:
            break;
    }
    return extracts ? depth_bits + 1 : depth_bits;  // extracted edge bits ride in the words of the depth buffer
}

int buffers_of(BramId id, AcceleratorConfig const& config) {
    return id == BramId::depth_buffer ? config.inlier_unit.buffers : config.edge_map.buffers;
}

std::uint64_t line_buffer_rows(AcceleratorConfig const& config) {
    if (config.flow == Flow::fpga_grip) {
        return extract_design(config).line_buffer_rows;
    }
    return sweep_design(config).has_line_buffers ? 2 : 0;
}

}  // namespace

MemoryShape memory_shape(BramId id, AcceleratorConfig const& config) {
    auto const side = static_cast<std::uint64_t>(config.window);
    MemoryShape memory;
    memory.bits = bits_of(id, config);
    memory.words = memory.bits > 0 ? side * side : 0;
    BankPartition const partition(config.bram(id).partition, config.window);
    memory.ports = config.bram(id).ports * partition.banks();
    memory.partition = partition.banks();
    memory.bank_words = partition.bank_words();
    memory.buffers = static_cast<std::uint64_t>(buffers_of(id, config));
    return memory;
}

MemoryShape line_buffer_shape(AcceleratorConfig const& config) {
    std::uint64_t const rows = line_buffer_rows(config);
    MemoryShape memory;
    LaneRows const tokens(config.window, config.inlier_unit.sweep_lanes);
    bool const extracts = config.flow == Flow::fpga_grip;  // pixel by pixel, whatever the sweep's lanes
    std::uint64_t const words = extracts ? static_cast<std::uint64_t>(config.window) : tokens.tokens_per_row();
    memory.words = rows > 0 ? words : 0;
    memory.bits = rows * (extracts ? 1 : tokens.lanes()) * depth_bits;
    return memory;
}

double ramb36_count(MemoryShape const& memory) {
    if (memory.words == 0 || memory.bits == 0) {
        return 0;
    }
    std::uint64_t const copies = divided_up(memory.ports, ports_per_primitive * memory.partition);
    double const banks = static_cast<double>(copies * memory.partition);
    std::uint64_t const words = std::max(memory.bank_words, divided_up(memory.words, memory.partition));
    return static_cast<double>(memory.buffers) * banks * ramb36_of_bank(words, memory.bits);
}

double ramb36_of_core(AcceleratorConfig const& config) {
    double sum = ramb36_count(line_buffer_shape(config));
    for (std::size_t i = 0; i < bram_count; ++i)
        sum += ramb36_count(memory_shape(static_cast<BramId>(i), config));
    return sum;
}

}  // namespace faster
