#pragma once
#include <array>
#include <cstdint>

namespace dataflow {

/// Seeded random numbers by a counter: Philox4x32-10 (Salmon, Moraes, Dror, Shaw: "Parallel random numbers: as easy as
/// 1, 2, 3", SC 2011). A number depends on seed, stream, substream and its place, and on nothing that was drawn
/// elsewhere; so whoever has a stream of his own draws the same numbers in whatever order and on however many threads
/// the others draw theirs. Normal numbers need portable::log() only: same bytes on every machine.
class CounterRandom {
  public:
    /// Key: the seed. Counter, from its lowest word: block, substream, and the two words of the stream.
    CounterRandom(std::uint64_t seed, std::uint64_t stream, std::uint32_t substream);

    /// 64 bits: two words of a block, the lower first.
    std::uint64_t bits();

    /// Uniform in [0, 1), a multiple of 2^-53.
    double uniform() { return 0x1p-53 * static_cast<double>(bits() >> 11); }

    /// Standard normal, by Marsaglia's polar method; the second value of the pair is dropped.
    double normal();

    /// A whole number in [0, count), `count` > 0; the bias is below 2^-32.
    std::uint32_t below(std::uint32_t count);

    using Block = std::array<std::uint32_t, 4>;
    /// The function itself, for tests against published values.
    static Block philox(Block counter, std::array<std::uint32_t, 2> key);

  private:
    std::array<std::uint32_t, 2> key_;
    Block counter_;
    Block block_{};
    int used_ = 2;  ///< halves of block_ that are spent
};

}  // namespace dataflow
