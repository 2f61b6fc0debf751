// Loops whose next call follows at once (docs/timing-model.md#rewind).
#include <catch2/catch.hpp>

#include "chance/pair.hpp"

namespace rewind_test {

using namespace faster;
using namespace faster::chance;
using Catch::Matchers::Contains;
using faster::Engine;

/// Ten tokens a call, written in stage 1 and read in stage 0.
Pair rewinding_pair() {
    Pair pair = sound_pair();
    pair.writer.loops.front().rewinds();
    pair.reader.loops.front().rewinds();
    return pair;
}

MachineSettings with_rewind(bool of_writer, bool of_reader) {
    MachineSettings settings;
    settings.loop("writer.send").rewind = of_writer;
    settings.loop("reader.receive").rewind = of_reader;
    return settings;
}

TEST_CASE("calls of a loop that rewinds follow each other by its interval") {
    // Token i is written in cycle i + 1 and read in i + 2; the last of three calls is read in 31, and done in 33.
    // Where either drains, calls are 12 cycles apart.
    MachineSettings const both = with_rewind(true, true), one = with_rewind(true, false),
                          none = with_rewind(false, false);
    Pair const pair = rewinding_pair();
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        CHECK(outcome_of(pair, engine, both, nullptr, 3) == "34 13 23 33");
        CHECK(outcome_of(pair, engine, one, nullptr, 3) == "38 13 25 37");
        CHECK(outcome_of(pair, engine, none, nullptr, 3) == "38 13 25 37");
        CHECK(outcome_of(pair, engine, both, &none, 3) == "38 13 25 37");
        CHECK(outcome_of(pair, engine, none, &both, 3) == "34 13 23 33");
    }
}

TEST_CASE("a loop drains if its module does anything else between calls") {
    Pair pair = rewinding_pair();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 10, [&](std::uint64_t) { fifo.read(); });
        clock.advance(1);
    };
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        CHECK(outcome_of(pair, engine, {}, nullptr, 3) == "41 14 27 40");
}

TEST_CASE("a loop that reads in a later stage cannot rewind") {
    Pair pair = rewinding_pair();
    pair.reader.ends.front().taken("receive", 1);
    CHECK_THAT(outcome_of(pair, Engine::decoupled),
               Contains("loop reader.receive rewinds, and reads a FIFO in a later stage than its first, expected ") &&
                   Contains("accelerator.loops.reader.receive.rewind: false"));
}

}  // namespace rewind_test
