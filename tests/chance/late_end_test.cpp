// Loops that go on until a token says otherwise that they read in a later stage
// (docs/timing-model.md#pipelined-loops).
#include <catch2/catch.hpp>
#include <cctype>

#include "chance/pair.hpp"

namespace late_end_test {

using namespace faster;
using namespace faster::chance;
using Catch::Matchers::Contains;
using faster::Engine;

constexpr Token last = 5;

/// Of forty tokens, the reader takes some until it knows of the last that it wants.
Pair ending_pair() {
    Pair pair = sound_pair();
    pair.writer.ends.front().keeps_tokens();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 40, [&](std::uint64_t i) { fifo.write(static_cast<Token>(i)); });
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        bool is_over = false;
        std::uint64_t begun = 0;
        clock.pipeline_while("receive", [&](std::uint64_t) {
            ++begun;
            clock.take_later(fifo, [&](Token token) { is_over = is_over || token == last; });
            return !is_over;
        });
        notes() = " " + std::to_string(begun);
    };
    return pair;
}

MachineSettings with(Cycles ii, Cycles read_stage, std::uint64_t depth = 64) {
    MachineSettings settings;
    settings.loop("reader.receive").ii = ii;
    settings.loop("reader.receive").depth = 9;
    settings.fifo("f").read_stage = read_stage;
    settings.fifo("f").depth = depth;
    return settings;
}

/// How many iterations the reader begins.
std::string begun(MachineSettings const& settings, Engine engine) {
    std::string const outcome = outcome_of(ending_pair(), engine, settings);
    return outcome.substr(outcome.rfind(' ') + 1);
}

TEST_CASE("a loop begins iterations until its module has the token that ends it") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        CHECK(begun(with(1, 0), engine) == "6");
        CHECK(begun(with(2, 1), engine) == "7");
        CHECK(begun(with(1, 1), engine) == "8");
        CHECK(begun(with(1, 3), engine) == "10");
        CHECK(begun(with(2, 3), engine) == "8");
    }
}

TEST_CASE("a loop that would begin other iterations is not retimed") {
    Pair const pair = ending_pair();
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        for (MachineSettings const& recorded : {with(1, 0), with(1, 3), with(2, 3), with(4, 3), with(5, 2)})
            for (MachineSettings const& other :
                 {with(1, 0), with(1, 3), with(2, 3), with(4, 3), with(5, 2), with(5, 3, 36)}) {
                std::string const retimed = outcome_of(pair, engine, recorded, &other);
                if (begun(recorded, engine) == begun(other, engine))
                    CHECK(retimed == outcome_of(pair, engine, other));
                else
                    CHECK_THAT(retimed, Contains("module reader may end its loop receive by what it accesses of f in a "
                                                 "later stage, before which "));
            }
}

}  // namespace late_end_test
