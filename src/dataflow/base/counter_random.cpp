#include "dataflow/base/counter_random.hpp"

#include <cmath>

#include "dataflow/base/portable_math.hpp"

namespace dataflow {

namespace {

std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

}  // namespace

CounterRandom::CounterRandom(std::uint64_t seed, std::uint64_t stream, std::uint32_t substream)
    : key_{low(seed), high(seed)}, counter_{0, substream, low(stream), high(stream)} {}

CounterRandom::Block CounterRandom::philox(Block counter, std::array<std::uint32_t, 2> key) {
    constexpr std::uint64_t multipliers[2]{0xD2511F53, 0xCD9E8D57};
    constexpr std::uint32_t weyl[2]{0x9E3779B9, 0xBB67AE85};
    for (int round = 0; round < 10; ++round) {
        std::uint64_t const a = multipliers[0] * counter[0];
        std::uint64_t const b = multipliers[1] * counter[2];
        counter = {high(b) ^ counter[1] ^ key[0], low(b), high(a) ^ counter[3] ^ key[1], low(a)};
        key[0] += weyl[0];
        key[1] += weyl[1];
    }
    return counter;
}

std::uint64_t CounterRandom::bits() {
    if (used_ == 2) {
        block_ = philox(counter_, key_);
        ++counter_[0];
        used_ = 0;
    }
    std::size_t const at = 2 * static_cast<std::size_t>(used_++);
    return block_[at] | std::uint64_t{block_[at + 1]} << 32;
}

double CounterRandom::normal() {
    while (true) {
        double const x = 2 * uniform() - 1;
        double const y = 2 * uniform() - 1;
        double const square = x * x + y * y;
        if (square > 0 && square < 1)
            return x * std::sqrt(-2 * portable::log(square) / square);
    }
}

std::uint32_t CounterRandom::below(std::uint32_t count) { return high(std::uint64_t{high(bits())} * count); }

}  // namespace dataflow
