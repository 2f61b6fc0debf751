#include <catch2/catch.hpp>

#include "chance/pair.hpp"

namespace wait_site_test {

using namespace faster;
using namespace faster::chance;

/// The line at which the first process that is stuck waits.
std::string line_of_wait(Pair const& pair, Engine engine) {
    testing::FreshKernel const kernel;
    auto const machine = std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), {}));
    RunStatistics const run = simulate(*accelerator_of(pair, machine, 1, engine));
    std::string const source = run.stuck.empty() ? "nobody is stuck" : run.stuck.front().source;
    return source.substr(source.find(':') + 1);
}

TEST_CASE("a deadlock names the line of the access that waits, however far ahead its module is") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (Token i = 0; i < 4; ++i) {
            clock.here({"writer.cpp", 100 + i});
            fifo.write(i);
            clock.advance(1);
        }
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(1); };
    CHECK(line_of_wait(pair, engine) == "102");  // two tokens have room
}

TEST_CASE("a deadlock names the line where the loop begins that waits, however far ahead its module is") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (Token i = 0; i < 4; ++i)
            clock.pipeline("send", 1, [&](std::uint64_t) { fifo.write(i); }, {"writer.cpp", 200 + i});
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(1); };
    CHECK(line_of_wait(pair, engine) == "202");
}

TEST_CASE("an access whose line nobody says has none, whatever was said of others") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        Step const step(clock);
        fifo.write(1);
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        {
            Step const step(clock);
            fifo.read();
        }
        clock.advance(1);
        fifo.read();
    };
    CHECK(line_of_wait(pair, engine) == "");
}

}  // namespace wait_site_test
