#include <catch2/catch.hpp>

#include "chance/pair.hpp"
#include "dataflow/run/config/calls.hpp"
#include "dataflow/tools/report/diagnosis_text.hpp"

namespace setup_test {

using namespace faster;
using namespace faster::chance;

/// The writer's setup cycles, whether its classes add up to the total, and the sentence about them.
std::string setups_of(Pair const& pair, Cycles starts, Engine engine) {
    testing::FreshKernel const kernel;
    MachineSettings settings;
    settings.start("writer") = starts;
    auto const machine = std::make_shared<Machine const>(
        make_machine(with_calls(core_of({pair.writer, pair.reader}), settings), settings));
    RunStatistics const run = simulate(*accelerator_of(pair, machine, 1, engine));
    ProcessStatistics const& writer = run.cores[0].processes[0];
    return std::to_string(writer[CycleClass::setup]) + (writer.sum() == run.total_cycles ? " " : " not all ") +
           dataflow::report::diagnosis_sentences(run).at(1);
}

TEST_CASE("What a module waits until it may start is setup, besides what it prepares") {
    Pair pair = sound_pair();
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        CHECK(setups_of(pair, 700, engine) == "700 98.0 % writer waits for the cycle in which it may start.");
    SetupDescription setup;
    setup.depth = 20;
    setup.activity = "preparing tokens";
    setup.before_loop = "send";
    setup.one_per_token_of = "f";
    pair.writer.setup = setup;
    pair.writes = [writes = pair.writes](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (int i = 0; i < 10; ++i)
            clock.set_up();
        writes(clock, fifo);
    };
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        CHECK(setups_of(pair, 7, engine) == "207 93.7 % is writer preparing tokens, 20 cycles each.");
}

}  // namespace setup_test
