#include "dataflow/base/counter_random.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"

namespace counter_random_test {

using namespace faster;
using Block = CounterRandom::Block;

TEST_CASE("Philox gives the numbers that its authors publish", "[random]") {
    // kat_vectors of Random123, philox4x32 with 10 rounds.
    CHECK(CounterRandom::philox({0, 0, 0, 0}, {0, 0}) == Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
    std::uint32_t const ones = 0xffffffff;
    CHECK(CounterRandom::philox({ones, ones, ones, ones}, {ones, ones}) ==
          Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
    CHECK(CounterRandom::philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("A stream begins with the block of its seed and counter, lower words first", "[random]") {
    CounterRandom random(0x1122334455667788, 0xaabbccdd00112233, 7);
    Block const block = CounterRandom::philox({0, 7, 0x00112233, 0xaabbccdd}, {0x55667788, 0x11223344});
    CHECK(random.bits() == (block[0] | std::uint64_t{block[1]} << 32));
    CHECK(random.bits() == (block[2] | std::uint64_t{block[3]} << 32));
    Block const next = CounterRandom::philox({1, 7, 0x00112233, 0xaabbccdd}, {0x55667788, 0x11223344});
    CHECK(random.bits() == (next[0] | std::uint64_t{next[1]} << 32));
}

TEST_CASE("Seeds, streams and substreams draw different numbers", "[random]") {
    std::set<std::uint64_t> first;
    for (std::uint64_t seed = 0; seed < 5; ++seed)
        for (std::uint64_t stream = 0; stream < 5; ++stream)
            for (std::uint32_t substream = 0; substream < 5; ++substream)
                first.insert(CounterRandom(seed, stream, substream).bits());
    CHECK(first.size() == 125);
}

TEST_CASE("Uniform numbers fill 0 to 1, normal ones have the moments and the share within one sigma", "[random]") {
    std::uint64_t const seed = GENERATE(1U, 2U, 3U);
    CAPTURE(seed);
    CounterRandom random(seed, 0, 0);
    int const draws = 100000;
    double uniform_sum = 0, sum = 0, squares = 0, fourths = 0, inside = 0;
    for (int i = 0; i < draws; ++i) {
        double const uniform = random.uniform();
        REQUIRE(uniform >= 0);
        REQUIRE(uniform < 1);
        uniform_sum += uniform;
        double const normal = random.normal();
        sum += normal;
        squares += normal * normal;
        fourths += normal * normal * normal * normal;
        inside += std::abs(normal) < 1 ? 1 : 0;
    }
    CHECK(uniform_sum / draws == Approx(0.5).margin(0.005));
    CHECK(sum / draws == Approx(0).margin(0.015));
    CHECK(squares / draws == Approx(1).margin(0.02));
    CHECK(fourths / draws == Approx(3).margin(0.2));
    CHECK(inside / draws == Approx(0.68269).margin(0.006));
}

TEST_CASE("Whole numbers below a limit are drawn alike", "[random]") {
    std::uint64_t const seed = GENERATE(range(1U, 6U));
    CAPTURE(seed);
    CounterRandom random(seed, 1, 2);
    constexpr std::uint32_t limit = 7;
    double counts[limit] = {};
    int const draws = 70000;
    for (int i = 0; i < draws; ++i)
        ++counts[random.below(limit)];
    double chi_square = 0;
    for (double const count : counts)
        chi_square += (count - 10000) * (count - 10000) / 10000;
    CHECK(chi_square < 27.9);  // 6 degrees of freedom: exceeded once in ten thousand
}

TEST_CASE("Portable functions are those of the C library, up to the last bits", "[random]") {
    for (double x = 1e-12; x < 1e12; x *= 1.37) {
        CAPTURE(x);
        CHECK(portable::log(x) == Approx(std::log(x)).epsilon(1e-14).margin(1e-15));
        CHECK(portable::pow(x, 0.3) == Approx(std::pow(x, 0.3)).epsilon(1e-13));
    }
    for (double x = -690; x < 690; x += 7.7)
        CHECK(portable::exp(x) == Approx(std::exp(x)).epsilon(1e-13));
    for (double x = -20; x < 20; x += 0.173) {
        CAPTURE(x);
        CHECK(portable::sine_and_cosine(x).sine == Approx(std::sin(x)).margin(1e-14));
        CHECK(portable::sine_and_cosine(x).cosine == Approx(std::cos(x)).margin(1e-14));
    }
    for (double x = 0; x < portable::pi / 2; x += 0.01)
        CHECK(portable::angle_of(std::sin(x), std::cos(x)) == Approx(x).margin(1e-14));
    CHECK(portable::pow(0, 3) == 0);
    CHECK(portable::pow(0, 0) == 1);
    CHECK(portable::exp(-1000) == 0);
}

TEST_CASE("What portable functions and normal numbers are, to the last bit", "[random]") {
    CHECK(portable::log(0.3) == -0x1.34378fcbda72p+0);
    CHECK(portable::exp(1.7) == 0x1.5e552770df8a7p+2);
    CHECK(portable::sine_and_cosine(2.5).sine == 0x1.326af0dcfcaafp-1);
    CHECK(portable::sine_and_cosine(2.5).cosine == -0x1.9a2f7ef858b8p-1);
    CHECK(portable::angle_of(1, 3) == 0x1.4978fa3269ee1p-2);
    CounterRandom random(42, 3, 1);
    CHECK(random.normal() == -0x1.8410538bcae82p-4);
    CHECK(random.normal() == -0x1.9076facb59212p-1);
}

}  // namespace counter_random_test
