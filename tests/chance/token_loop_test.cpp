#include <catch2/catch.hpp>
#include <string>
#include <tuple>

#include "chance/pair.hpp"

namespace token_loop_test {

// Loops by tokens_of(): random designs have them beside loops of plain accesses; here is what those do not do.

using namespace faster;
using namespace faster::chance;
using Catch::Matchers::Equals;

constexpr std::uint64_t tokens = 3000;  // more than are written at once

auto into(ClockedFifo<Token>& fifo) { return token_ports(std::tuple(), std::tuple(&fifo)); }
auto from(ClockedFifo<Token>& fifo) { return token_ports(std::tuple(&fifo), std::tuple()); }

/// Numbers until the last; the reader says what they add up to, and how many it has had.
Pair counting_pair() {
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline_while("send", into(fifo), [](std::uint64_t i, Token& token) {
            token = static_cast<Token>(i);
            return i + 1 < tokens;
        });
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        std::uint64_t sum = 0;
        std::uint64_t count = 0;
        clock.pipeline_while("receive", from(fifo), [&](Token token) {
            sum += token;
            ++count;
            return token + 1 < tokens;
        });
        notes() = " sum " + std::to_string(sum) + " of " + std::to_string(count);
    };
    return pair;
}

/// Numbers by plain accesses, as many.
Pair plain_pair() {
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", tokens, [&](std::uint64_t i) { fifo.write(static_cast<Token>(i)); });
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", tokens, [&](std::uint64_t) { fifo.read(); });
    };
    return pair;
}

TEST_CASE("a loop ends with the token that its body says, and takes the cycles of plain accesses") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        std::string const cycles = outcome_of(plain_pair(), engine);
        CHECK_THAT(outcome_of(counting_pair(), engine), Equals(cycles + " sum 4498500 of 3000"));
    }
}

TEST_CASE("tokens read in a later stage, or in a loop that makes attempts, are taken one by one") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        Pair late = counting_pair();
        Pair plain = plain_pair();
        for (Pair* const pair : {&late, &plain})
            pair->reader.ends.front().read_stage = 2;
        CHECK_THAT(outcome_of(late, engine), Equals(outcome_of(plain, engine) + " sum 4498500 of 3000"));
        for (Pair* const pair : {&late, &plain}) {
            pair->writer.reads_from("g").taken("send", 0).non_blocking();
            pair->reader.writes_to("g").of_bits(1);
        }
        CHECK_THAT(outcome_of(late, engine), Equals(outcome_of(plain, engine) + " sum 4498500 of 3000"));
    }
}

TEST_CASE("a token to be written is fresh, whatever was written before") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        Pair pair = counting_pair();
        pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("send", tokens, into(fifo),
                           [](std::uint64_t i, Token& token) { token += i + 1 < tokens ? 1 : static_cast<Token>(i); });
        };
        CHECK_THAT(outcome_of(pair, engine), Equals(outcome_of(plain_pair(), engine) + " sum 5998 of 3000"));
    }
}

TEST_CASE("without an iteration a pipelined loop is not entered") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        Pair pair = sound_pair();
        pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("send", 0, into(fifo), [](Token& token) { token = 1; });
            clock.pipeline("send", 0);
            clock.advance(7);
        };
        pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("receive", 0, from(fifo), [](Token) {});
            clock.advance(3);
        };
        CHECK_THAT(outcome_of(pair, engine), Equals("7"));
    }
}

}  // namespace token_loop_test
