#include "dataflow/run/replay/replay.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <memory>
#include <vector>

#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/plain_reader.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing::replay_test {

constexpr int samples = 40;

events::EventFile recorded_run(test::TempFolder const& folder, AcceleratorConfig const& config) {
    RandomStimulusOptions options;
    options.samples = {samples, samples};
    options.triangles = {1, 12};
    TestRunOptions fork;
    fork.events = folder / "events";
    test_run(config, random_stimulus(9400, options), Engine::decoupled, fork);
    return events::read_event_file(fork.events);
}

/// What somebody asks of scripts, or of the first of them.
class Watched : public replay::ScriptSource {
  public:
    explicit Watched(replay::ScriptSource const& source, std::size_t most = samples) : source_(source), most_(most) {}

    timing::PhraseBook const& book() const override { return source_.book(); }
    std::size_t size() const override { return std::min(source_.size(), most_); }
    replay::ScriptedSample const& operator[](std::size_t sample) const override {
        furthest = std::max(furthest, sample + 1);
        return source_[sample];
    }

    timing::PhraseCore::Form const& form() const override { return source_.form(); }

    mutable std::size_t furthest = 0;  ///< samples up to the last that was asked for

  private:
    replay::ScriptSource const& source_;
    std::size_t most_;
};

/// In which the inlier unit waits for commands of a rasterizer that has no room for a fragment.
AcceleratorConfig deadlocking(AcceleratorConfig config) {
    config.fifo(FifoId::fragment_depth).depth = 1;
    return config;
}

struct Asked {
    std::size_t plain = 0;  ///< samples
    bool is_stuck = false;
    std::vector<Cycles> ends;  ///< of processes
};

/// One of those that samples are told to.
std::unique_ptr<timing::PhraseCore> core_of(replay::ScriptedRun const& run, Machine const& machine) {
    auto core = replay::core_variant(*run.run().blueprint, machine);
    core->let_follow(machine.lead, timing::make_answers());
    return core;
}

/// What one core asks for that does all samples.
Asked replay_all(replay::ScriptSource const& source, replay::ScriptedRun const& run, AcceleratorConfig const& config) {
    Asked asked;
    Machine const machine = raster_machine(config);
    auto const core = core_of(run, machine);
    replay::PlainReader reader(run.run());
    auto const plain = [&](std::size_t sample) {
        ++asked.plain;
        return reader.read(sample);
    };
    replay::Replay replay(source, plain, {0, samples}, *core, machine.lead);
    while (replay.go_on())
        core->let_walk();
    core->resolve();
    asked.is_stuck = !core->blocked().empty();
    for (timing::ProcessTiming const& process : core->processes())
        asked.ends.push_back(process.local_time());
    return asked;
}

TEST_CASE("Where nobody can go on any more, no further samples are read", "[replay]") {
    test::TempFolder const folder;
    events::EventFile const file = recorded_run(folder, AcceleratorConfig());
    AcceleratorConfig const recorded = accelerator_of(file.loaded.config);
    replay::ScriptedRun const run(file.run);
    for (bool const scripted : {false, true}) {
        CAPTURE(scripted);
        Watched const watched(run);
        replay::ScriptSource const none;
        replay::ScriptSource const& source = scripted ? static_cast<replay::ScriptSource const&>(watched) : none;
        Asked const stuck = replay_all(source, run, deadlocking(recorded));
        CHECK(stuck.is_stuck);
        CHECK(stuck.plain + watched.furthest < 8);

        watched.furthest = 0;
        Asked const done = replay_all(source, run, recorded);
        CHECK_FALSE(done.is_stuck);
        CHECK(done.plain + watched.furthest == samples);
    }
}

TEST_CASE("Samples that no script has are told as they were, behind others that were told in steps", "[replay]") {
    test::TempFolder const folder;
    AcceleratorConfig config;
    config.rasterizer.setup_overlap = 2;
    events::EventFile const file = recorded_run(folder, config);
    Machine const machine = raster_machine(config);
    replay::ScriptedRun const run(file.run);
    auto const formed = run.samples_for(*core_of(run, machine), machine);
    bool const has_lookup = timing::make_answers() != nullptr;
    CHECK(formed->form().empty() != has_lookup);
    Asked const whole = replay_all(*formed, run, config);
    CHECK(whole.plain == 0);
    for (std::size_t const scripted : {0U, 1U, 20U, 39U}) {
        CAPTURE(scripted);
        Asked const part = replay_all(Watched(*formed, scripted), run, config);
        CHECK(part.plain == samples - scripted);
        CHECK(part.ends == whole.ends);
    }
    Asked const as_told = replay_all(run, run, config);
    CHECK(as_told.plain == 0);
    CHECK(as_told.ends == whole.ends);
}

}  // namespace faster::testing::replay_test
