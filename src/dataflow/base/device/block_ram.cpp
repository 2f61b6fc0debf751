#include "dataflow/base/device/block_ram.hpp"

#include <algorithm>
#include <array>

#include "dataflow/base/device/primitive_shapes.hpp"

namespace dataflow {
namespace {

constexpr std::uint64_t ports_per_primitive = 2;

constexpr std::array<PrimitiveShape, 6> ramb36_shapes{
    {{32768, 1}, {16384, 2}, {8192, 4}, {4096, 9}, {2048, 18}, {1024, 36}}};
constexpr std::array<PrimitiveShape, 5> ramb18_shapes{{{16384, 1}, {8192, 2}, {4096, 4}, {2048, 9}, {1024, 18}}};

double ramb36_of_bank(std::uint64_t words, std::uint64_t bits) {
    return fewest(words, bits, ramb18_shapes) == 1 ? 0.5 : static_cast<double>(fewest(words, bits, ramb36_shapes));
}

}  // namespace

double ramb36_count(MemoryShape const& memory) {
    if (memory.words == 0 || memory.bits == 0) {
        return 0;
    }
    std::uint64_t const copies = divided_up(memory.ports, ports_per_primitive * memory.partition);
    double const banks = static_cast<double>(copies * memory.partition);
    std::uint64_t const words = std::max(memory.bank_words, divided_up(memory.words, memory.partition));
    return memory.share * static_cast<double>(memory.buffers) * banks * ramb36_of_bank(words, memory.bits);
}

}  // namespace dataflow
