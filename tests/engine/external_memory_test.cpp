#include <catch2/catch.hpp>
#include <sstream>

#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/tools/explore/replayed_timeline.hpp"
#include "dataflow/tools/recording/core_timeline.hpp"
#include "faster/dataflow_names.hpp"
#include "support/engine_agreement.hpp"
#include "support/memory_trials.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing::external_memory_test {

std::string text_of(SampleTimeline const& timeline) {
    std::ostringstream text;
    text << "sample " << timeline.sample << " core " << timeline.core << ' ' << timeline.begin << '-' << timeline.end;
    for (TimelineSpan const& span : timeline.spans)
        text << "\n"
             << span.module << ' ' << static_cast<int>(span.kind) << ' ' << span.item << ' ' << span.begin << '-'
             << span.end << ' ' << span.count;
    for (std::vector<OccupancyPoint> const& points : timeline.occupancy)
        for (OccupancyPoint const& point : points)
            text << ' ' << point.cycle << ':' << point.tokens;
    return text.str();
}

/// Of every sample of a run, as it goes on.
std::vector<std::string> timelines_of_run(AcceleratorConfig const& config, Stimulus const& stimulus) {
    test::TempFolder const folder;
    TestRunOptions fork;
    for (std::size_t sample = 0; sample < stimulus.samples.size(); ++sample) {
        Recording recording;
        recording.window.samples = recording::RecordingWindow::Samples{sample, sample};
        recording.done = [&folder, sample](recording::RecordedWindow const& window) {
            for (recording::RecordedCore const& core : window.cores)
                folder.write(std::to_string(sample), text_of(recording::sample_timeline(core, sample)));
        };
        fork.recordings.push_back(recording);
    }
    REQUIRE_FALSE(test_run(config, stimulus, Engine::decoupled, fork).statistics.deadlocked());
    std::vector<std::string> texts;
    for (std::size_t sample = 0; sample < stimulus.samples.size(); ++sample)
        texts.push_back(test::content_of(folder / std::to_string(sample)));
    return texts;
}

std::vector<std::string> replayed_timelines(replay::RecordedRun const& recorded, AcceleratorConfig const& config) {
    Machine const machine = raster_machine(config);
    RunStatistics const run = replay::retime(recorded, machine);
    std::vector<std::string> texts(run.samples.size());
    explore::replay_timelines(recorded, machine, run.samples,
                              [&](std::size_t i, SampleTimeline const& timeline) { texts[i] = text_of(timeline); });
    return texts;
}

/// Returns how many samples were compared.
std::size_t check_replayed_timelines(std::uint64_t seed, MemoryModel model) {
    CAPTURE(seed);
    MemoryTrial trial = memory_trial(seed);
    trial.config.external_memory.model = model;
    test::TempFolder const folder;
    TestRunOptions fork;
    fork.events = folder / "events";
    if (test_run(trial.config, trial.stimulus, Engine::decoupled, fork).statistics.deadlocked())
        return 0;
    events::EventFile const file = events::read_event_file(fork.events);
    for (AcceleratorConfig const& config : {trial.config, other_timing(seed, trial.config)})
        CHECK(replayed_timelines(file.run, config) == timelines_of_run(config, trial.stimulus));
    return trial.stimulus.samples.size();
}

TEST_CASE("Replayed timelines of samples are those that the run would have recorded, seeds 20001 to 20010",
          "[memory][timeline]") {
    for (MemoryModel const model : {MemoryModel::axi, MemoryModel::ideal}) {
        std::size_t samples = 0;
        for (std::uint64_t seed = 20001; seed <= 20010; ++seed)
            samples += check_replayed_timelines(seed, model);
        CHECK(samples > 20);
    }
}

TEST_CASE("Engines and twin agree behind external memory, seeds 20000 to 20039", "[engine_vs_twin][memory]") {
    int const deadlocks = check_memory_seeds(20000, 40);
    CHECK(deadlocks > 2);  // or the mixture tests nothing
    CHECK(deadlocks < 12);
}

TEST_CASE("Engines and twin agree behind external memory, large windows", "[engine_vs_twin][memory]") {
    CHECK(check_memory_seeds(first_with_large_windows, 12) < 6);
}

TEST_CASE("Recorded runs behind external memory are retimed as they would run, seeds 20000 to 20019",
          "[engine_vs_twin][memory][retime]") {
    CHECK(check_memory_retimings(20000, 20) > 12);
}

TEST_CASE("A memory that nothing limits costs the engines what the page derives", "[memory]") {
    // A window of 4 with a triangle of three fragments, which the only core waits for: docs/memory-model.md, By hand.
    Stimulus stimulus;
    stimulus.width = stimulus.height = 8;
    stimulus.window = 4;
    stimulus.observed_depth = Image<std::uint16_t>(8, 8, 512);
    stimulus.observed_edges = Image<std::uint8_t>(8, 8, 1);
    stimulus.triangles.push_back(TriangleCode{{{16, 16, 1U << 14}, {16, 32, 1U << 14}, {32, 16, 1U << 14}}});
    AcceleratorConfig config;
    config.cores = 1;
    adopt(stimulus, config);
    for (std::size_t const samples : {1U, 2U, 5U})
        for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
            stimulus.samples.assign(samples, SampleInput{2, 2, 0, 1});
            AcceleratorConfig axi = config;
            axi.external_memory.model = MemoryModel::axi;
            Cycles const ideal = test_run(config, stimulus, engine).statistics.total_cycles;
            Cycles const usual = test_run(axi, stimulus, engine).statistics.total_cycles;
            axi.external_memory.outstanding = 1000000;
            axi.external_memory.request_cycles = 0;
            axi.external_memory.read_latency_ns = 0;
            axi.external_memory.dram_gb_per_s = 1e6;
            CHECK(test_run(axi, stimulus, engine).statistics.total_cycles == ideal + (samples == 1 ? 5 : 8));
            if (samples == 1)
                CHECK(usual == ideal + 101);
        }
}

// 21561: an empty mesh on the chip, at an odd address; 21200: a deadlock of a process that had tokens left to read when
// it was last told something; the others: bursts that end with the begin of a token.
TEST_CASE("Engines and twin agree behind external memory where they did not at first", "[engine_vs_twin][memory]") {
    for (std::uint64_t const seed : {21561U, 21444U, 21200U, 30042U, 31230U})
        CHECK(check_memory_seeds(seed, 1) >= 0);
}

TEST_CASE("Tokens that need no memory, more than there is room for at first, go on as before",
          "[engine_vs_twin][memory]") {
    // Windows beyond the image's edges: a thousand pixels lie between those that are fetched for one sample and the
    // next.
    Stimulus stimulus;
    stimulus.width = 75;
    stimulus.height = 20;
    stimulus.window = 40;
    stimulus.observed_depth = Image<std::uint16_t>(20, 75, 0);
    stimulus.observed_edges = Image<std::uint8_t>(20, 75, 0);
    VertexCode const outside{-32768, -32768, 0};
    stimulus.triangles.assign(1394, TriangleCode{{outside, outside, outside}});
    stimulus.samples = {{15, 66, 0, 0}, {4, 66, 0, 0}, {19, 28, 0, 646}, {7, 35, 0, 1394}};
    AcceleratorConfig config;
    config.cores = 2;
    config.fifo(FifoId::edge_map).depth = 16;
    config.setup("rasterizer") = 1;
    config.external_memory.model = MemoryModel::axi;
    config.external_memory.prefetch = true;
    config.external_memory.outstanding = 4;
    config.external_memory.dram_gb_per_s = 1.5;
    config.external_memory.request_cycles = 100;
    adopt(stimulus, config);
    CHECK(check_agreement(config, stimulus));
}

}  // namespace faster::testing::external_memory_test
