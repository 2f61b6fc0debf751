// Functions over hls::stream by chance, against a simulation cycle by cycle that knows the rules of docs/hls.md alone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <deque>
#include <hls_design.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "chance/chance_design.hpp"
#include "chance/chance_functions.hpp"
#include "chance/chance_twin.hpp"
#include "chance/elaborated.hpp"
#include "chance/figures.hpp"
#include "channels/simulate.hpp"
#include "dataflow/base/byte_stream.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "faster/dataflow_names.hpp"
#include "support/forked_bytes.hpp"
#include "support/fresh_kernel.hpp"

namespace faster::chance::functions_test {

Design& design_at_hand() {
    static Design design;
    return design;
}

/// Functions that do what the data of the design at hand says.
class ChanceFunctions : public HlsDesign {
  public:
    explicit ChanceFunctions(Numbers const& /*numbers*/) {
        Design const& design = design_at_hand();
        for (Fifo const& fifo : design.fifos)
            streams_.push_back(std::make_unique<hls::stream<std::int32_t>>(fifo.name));
        written_.resize(design.fifos.size());
        read_.resize(design.fifos.size());
        marks_.resize(design.processes.size());
        for (std::size_t i = 0; i < design.processes.size(); ++i) {
            for (Loop const& loop : design.processes[i].loops)
                marks_[i].push_back(mark_of(loop));
            process(design.processes[i].name, [this, i] { call(i); });
        }
    }
    static SimpleFacts facts() { return {"functions", {}, {}}; }

  private:
    static untimed::LoopMark mark_of(Loop const& loop) {
        auto const depth = static_cast<unsigned>(loop.depth);
        unsigned const ii = loop.is_pipelined ? static_cast<unsigned>(loop.ii) : loop.entry > 0 ? depth : 0;
        return {loop.name.c_str(), ii, depth, loop.is_pipelined};
    }

    void call(std::size_t number) {
        for (Segment const& segment : design_at_hand().processes[number].program) {
            for (std::size_t const fifo : segment.step)
                access(number, fifo);
            for (Accesses const& iteration : segment.iterations) {
                untimed::Iteration const one(marks_[number][segment.loop]);
                for (std::size_t const fifo : iteration)
                    access(number, fifo);
            }
        }
    }
    void access(std::size_t number, std::size_t fifo) {
        if (design_at_hand().writes(number, fifo))
            streams_[fifo]->write(written_[fifo]++);
        else if (streams_[fifo]->read() != read_[fifo]++)
            throw std::logic_error("a token is not what was written");
    }

    std::vector<std::unique_ptr<hls::stream<std::int32_t>>> streams_;
    std::vector<std::int32_t> written_, read_;          // tokens, by stream
    std::vector<std::deque<untimed::LoopMark>> marks_;  // by process and loop
};

SimpleSimulation<HlsCoreOf<ChanceFunctions>> const& simulation() {
    static SimpleSimulation<HlsCoreOf<ChanceFunctions>> const one(ChanceFunctions::facts());
    return one;
}

/// The description lists streams and loops as functions come to them, so lines are in the order of names.
std::string difference(Figures found, Figures expected) {
    std::sort(found.lines.begin(), found.lines.end());
    std::sort(expected.lines.begin(), expected.lines.end());
    return first_difference(found, expected);
}

/// Of a run, of its recording retimed, and of that retimed as another design.
using Outcome = std::vector<Figures>;

Outcome run_here(Design const& design, Design const& other, Engine engine) {
    testing::FreshKernel const kernel;
    Elaborated const made(simulation(), design, engine);
    replay::RecordedRun recorded;
    SimulationOptions options;
    options.recorded = &recorded;
    Outcome outcome{figures_of(simulate(*made.accelerator, options))};
    if (!outcome.front().is_stuck) {
        outcome.push_back(figures_of(replay::retime(recorded, *made.machine)));
        RunConfig config = made.loaded.config;
        config.machine() = settings_of(other);
        outcome.push_back(figures_of(replay::retime(recorded, machine_of(config))));
    }
    return outcome;
}

/// In both engines, by a process of its own: a program has one design and its keys.
std::vector<Outcome> run_forked(Design const& design, Design const& other) {
    std::vector<Outcome> outcomes(2);
    ValueReader reader(testing::forked_bytes([&] {
        design_at_hand() = design;
        ValueWriter writer;
        for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
            Outcome const outcome = run_here(design, other, engine);
            writer.put(outcome.size());
            for (Figures const& figures : outcome)
                put(writer, figures);
        }
        return writer.bytes();
    }));
    for (Outcome& outcome : outcomes) {
        outcome.resize(reader.get_size());
        for (Figures& figures : outcome)
            figures = figures_from(reader);
    }
    return outcomes;
}

TEST_CASE("functions by chance do the same in both engines, retimed, and in a simulation cycle by cycle") {
    std::uint64_t const first = asked("CHANCE_SEED", 1), designs = asked("CHANCE_DESIGNS", 60);
    std::uint64_t stuck = 0;
    for (std::uint64_t seed = first; seed < first + designs; ++seed) {
        Design const design = random_functions(seed), other = retimed(design, seed);
        CAPTURE(seed, text_of(design));
        Figures const twin = simulated(design), other_twin = simulated(other);
        stuck += twin.is_stuck ? 1U : 0U;
        std::vector<Outcome> const outcomes = run_forked(design, other);
        for (Outcome const& outcome : outcomes) {
            CAPTURE(&outcome == &outcomes.front());  // lockstep
            CHECK(difference(outcome.front(), twin) == "");
            if (twin.is_stuck)
                continue;
            REQUIRE(outcome.size() == 3);
            CHECK(difference(outcome[1], twin) == "");
            INFO(text_of(other));
            CHECK(difference(outcome[2], other_twin) == "");
        }
    }
    WARN(designs << " designs of functions from seed " << first << " on: " << stuck << " get stuck");
    if (designs >= 60) {
        CHECK(stuck > designs / 20);
        CHECK(stuck < designs / 2);
    }
}

}  // namespace faster::chance::functions_test

dataflow::Design const& dataflow::design() { return faster::chance::functions_test::simulation(); }
dataflow::SimulatedDesign const& dataflow::simulated_design() { return faster::chance::functions_test::simulation(); }
