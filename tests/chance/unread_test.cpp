#include <catch2/catch.hpp>

#include "chance/pair.hpp"
#include "dataflow/tools/sizing/core_times.hpp"

namespace unread_test {

using namespace faster;
using namespace faster::chance;
using faster::Engine;

TEST_CASE("tokens that nobody ever reads need room, too") {
    Pair pair = sound_pair();
    pair.writer.ends.front().keeps_tokens();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(3); };
    MachineSettings deep;
    deep.fifo("f").depth = 64;
    auto const machine = std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), deep));
    std::string const room = testing::forked_bytes([&] {
        replay::RecordedRun recorded;
        SimulationOptions options;
        options.recorded = &recorded;
        simulate(*accelerator_of(pair, machine, 1, Engine::decoupled), options);
        sizing::CoreTimes times(recorded, *machine);
        sizing::Choice const choice = sizing::choice_of(*machine);
        times.total_cycles(choice, 1);
        return std::to_string(times.needed_room(choice, 0));
    });
    CHECK(room == "11");  // never to be full with ten
}

}  // namespace unread_test
