#include <catch2/catch.hpp>
#include <random>
#include <utility>
#include <vector>

#include "chance/pair.hpp"
#include "dataflow/tools/sizing/core_times.hpp"

namespace needed_room_test {

using namespace faster;
using namespace faster::chance;
using faster::Engine;

replay::RecordedRun recorded_run(Pair const& pair, std::shared_ptr<Machine const> const& machine) {
    testing::FreshKernel const kernel;
    replay::RecordedRun recorded;
    SimulationOptions options;
    options.recorded = &recorded;
    simulate(*accelerator_of(pair, machine, 1, Engine::decoupled), options);
    return recorded;
}

TEST_CASE("tokens that nobody ever reads need room, too") {
    Pair pair = sound_pair();
    pair.writer.ends.front().keeps_tokens();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(3); };
    MachineSettings deep;
    deep.fifo("f").depth = 64;
    auto const machine = std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), deep));
    replay::RecordedRun const recorded = recorded_run(pair, machine);
    sizing::CoreTimes times(recorded, *machine);
    sizing::Choice const choice = sizing::choice_of(*machine);
    times.total_cycles(choice, 1);
    CHECK(times.needed_room(choice, 0) == 11);  // never to be full with ten
}

/// Bursts of tokens, each in one cycle, and as many reads.
Pair bursts(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    auto const below = [&random](std::uint64_t end) { return random() % end; };
    std::vector<std::pair<std::uint64_t, Cycles>> written;  // tokens, and cycles behind them
    std::vector<Cycles> read;
    for (std::uint64_t i = 4 + below(5); i > 0; --i) {
        written.emplace_back(1 + below(4), 1 + below(5));
        for (std::uint64_t tokens = written.back().first; tokens > 0; --tokens)
            read.push_back(below(2) == 0 ? below(2) : below(4));
    }
    Pair pair = sound_pair();
    pair.writes = [written](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (auto const& [tokens, cycles] : written) {
            for (Token i = 0; i < tokens; ++i)
                fifo.write(i);
            clock.advance(cycles);
        }
    };
    pair.reads = [read](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (Cycles const cycles : read) {
            fifo.read();
            clock.advance(cycles);
        }
        clock.advance(1);
    };
    return pair;
}

TEST_CASE("tokens that are written in one cycle need room for all of them") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Pair const pair = bursts(seed);
        auto const with_depth = [&pair](std::uint64_t depth) {
            MachineSettings settings;
            settings.fifo("f").depth = depth;
            return make_machine(core_of({pair.writer, pair.reader}), settings);
        };
        auto const machine = std::make_shared<Machine const>(with_depth(16));
        replay::RecordedRun const recorded = recorded_run(pair, machine);
        sizing::CoreTimes times(recorded, *machine);
        for (std::uint64_t depth = 16; depth > 0; --depth) {
            Machine const other = with_depth(depth);
            RunStatistics const run = replay::retime(recorded, other);
            CAPTURE(seed, depth);
            CHECK(times.total_cycles(sizing::choice_of(other), 1) ==
                  (run.deadlocked() ? sizing::Cut::deadlock : run.total_cycles));
        }
    }
}

}  // namespace needed_room_test
