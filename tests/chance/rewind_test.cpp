// Loops whose next call follows at once (docs/timing-model.md#rewind).
#include <catch2/catch.hpp>
#include <map>
#include <utility>

#include "chance/chance_simulation.hpp"
#include "chance/chance_twin.hpp"
#include "chance/pair.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "dataflow/tools/recording/event_merge.hpp"

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

/// Calls of two modules that read and write two FIFOs in each of two iterations. The first and the third do nothing.
Design calls_without_work() {
    Design design;
    design.processes.resize(2);
    for (Process& process : design.processes) {
        process.name = &process == design.processes.data() ? "writer" : "reader";
        process.ends = {0, 1};
        Loop loop;
        loop.name = "work";
        process.loops = {loop};
        Segment segment;
        segment.kind = Segment::Kind::loop;
        segment.iterations = {{0, 1}, {0, 1}};
        process.program = {segment};
    }
    for (Cycles const stage : {Cycles{3}, Cycles{2}}) {
        Fifo fifo;
        fifo.name = stage == 3 ? "late" : "early";
        fifo.reader = 1;
        fifo.write_stage = stage;
        design.fifos.push_back(fifo);
    }
    Loop& loop = design.processes.front().loops.front();
    loop.depth = 6;
    loop.can_rewind = loop.rewinds = true;
    design.samples = 4;
    design.idle_samples = {true, false, true, false};
    return design;
}

TEST_CASE("tokens of a call wait in a loop that rewinds for a call that has iterations") {
    Design const design = calls_without_work();
    std::vector<std::string> const expected = simulated(design).lines;
    for (Outcome const& outcome : run_forked(design, design, true)) {
        CHECK(outcome.error == "");
        CHECK(outcome.run.lines == expected);
        if (!outcome.is_recorded)
            continue;
        for (Figures const* const figures : {&outcome.as_is, &outcome.from_file, &outcome.other})
            CHECK(figures->lines == expected);
        CHECK(outcome.sized.has_value());
    }
}

TEST_CASE("a waveform has the reads of a call in their cycles, though the one before ends later") {
    Pair pair = rewinding_pair();
    pair.reader.loops.front().of_depth(9);
    Recording reads;
    reads.done = [](recording::RecordedWindow const& window) {
        recording::Spools* const spools = window.cores.front().spools;
        std::map<std::size_t, Cycles> last;  // by process
        recording::for_each_event({{0, spools}}, [&last](recording::CoreEvent const& event) {
            if (event.event.kind == recording::Event::Kind::read)
                notes() += " " + std::to_string(event.event.cycle);
            if (event.event.cycle < std::exchange(last[event.process], event.event.cycle))
                notes() += " too late";
        });
    };
    std::string expected = "40 19 29 39";  // the totals and when the calls end
    for (int token = 0; token < 30; ++token)
        expected += " " + std::to_string(token + 2);
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        CHECK(outcome_of(pair, engine, {}, nullptr, 3, {reads}) == expected);
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

TEST_CASE("a loop that reads in a later stage, or makes attempts, cannot rewind") {
    Pair pair = rewinding_pair();
    auto const obstacle = [&] {
        Machine const machine = make_machine(core_of({pair.writer, pair.reader}), {});
        char const* const found = against_rewinding(machine, machine.loops[machine.loop(1, "receive")]);
        return std::string(found == nullptr ? "" : found);
    };
    CHECK(obstacle() == "");
    pair.reader.ends.front().taken("receive", 1);
    CHECK(obstacle() == "reads a FIFO in a later stage than its first");
    pair.reader.ends.front().taken("receive", 0).non_blocking();
    CHECK(obstacle() == "accesses a FIFO without waiting");
}

/// The hazards of three calls that write a word last and read it first. The clock says where a call begins anew.
std::string hazards_of(MachineSettings const& settings, Engine engine) {
    Pair pair = rewinding_pair();
    constexpr PixelOffset own{0, 0};
    pair.reader.loops.front().of_depth(4).accesses_memory("m", {{own}, {own}}).in_stages({"m", 0, 2, 1, 1});
    pair.reader.memory("m").of_words(1, 2, 8);
    WriteDistances* distances = nullptr;
    pair.reads = [&distances](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        if (distances == nullptr)
            distances = clock.write_distances("receive", "m");
        clock.pipeline("receive", 10, [&](std::uint64_t i) {
            distances->next_iteration();
            if (i == 0)
                distances->read(0);
            fifo.read();
            if (i == 9)
                distances->write(0);
        });
    };
    testing::FreshKernel const kernel;
    auto const machine = std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), settings));
    SimulationOptions options;
    options.hazards = true;
    RunStatistics const run = simulate(*accelerator_of(pair, machine, 3, engine), options);
    return std::to_string(dependence_sums(run).at(0).hazards());
}

TEST_CASE("iterations of a loop that rewinds meet those of the call before, of others they do not") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        CHECK(hazards_of(with_rewind(true, true), engine) == "2");
        CHECK(hazards_of(with_rewind(true, false), engine) == "0");
    }
}

}  // namespace rewind_test
