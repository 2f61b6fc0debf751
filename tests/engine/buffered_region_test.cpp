#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <stdexcept>

#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "faster/dataflow_names.hpp"
#include "support/counters.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/recorded_accesses.hpp"
#include "support/run_cells.hpp"
#include "support/small_stimulus.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

// Double buffers of which only the touched region is read out: the region has to stay with its buffer.

namespace faster::testing::buffered_region_test {

AcceleratorConfig with_two_of_each(SweepRegion region) {
    AcceleratorConfig config = with_cores(1);
    config.inlier_unit.sweep_region = region;
    config.edge_map.buffers = config.inlier_unit.buffers = 2;
    return config;
}

struct Trial {
    Stimulus stimulus;
    AcceleratorConfig config;
};

/// Any machine with two of each and a touched region.
Trial trial_of(std::uint64_t seed, RandomConfigOptions machine = {}) {
    RandomStimulusOptions work;
    work.width = {24, 48};
    work.height = {24, 48};
    work.window = {6, 24};
    work.samples = {4, 9};
    machine.cores = {1, 2};
    machine.algorithm = static_cast<EdgeMapAlgorithm>(seed % 6);
    machine.any_scan = machine.any_partition = true;
    machine.max_lanes = 6;
    machine.max_scan_lanes = machine.algorithm == EdgeMapAlgorithm::inner_border ? 6 : 1;
    machine.any_region = machine.any_buffers = true;
    Trial trial{random_stimulus(seed, work), random_config(seed, machine)};
    trial.config.inlier_unit.sweep_region = SweepRegion::touched;
    trial.config.edge_map.buffers = trial.config.inlier_unit.buffers = 2;
    adopt(trial.stimulus, trial.config);
    return trial;
}

/// The words of each buffer that have been drawn and not yet cleared.
class DirtyWords {
  public:
    /// Which buffers a reading of `fifo` gives to a process that draws.
    static std::set<BramId> drawn_next(FifoId fifo) {
        return fifo == FifoId::map_free     ? std::set{BramId::edge_map, BramId::object_map}
               : fifo == FifoId::depth_free ? std::set{BramId::depth_buffer}
                                            : std::set<BramId>{};
    }
    void take(std::size_t module, recording::PortAccess const& access) {
        if (!access.writes)
            return;
        bool const draws = module == index_of(ModuleId::edge_map_builder) || module == index_of(ModuleId::inlier_unit);
        std::set<std::uint64_t>& words = words_[{access.memory, access.buffer}];
        if (draws)
            words.insert(access.address);
        else
            words.erase(access.address);
        drawn_ += draws ? 1U : 0U;
    }
    void give(BramId bram, std::size_t buffer) const {
        auto const words = words_.find({index_of(bram), buffer});
        if (words != words_.end() && !words->second.empty())
            throw std::runtime_error("buffer " + std::to_string(buffer) + " of " + name_of(bram) +
                                     " is not clear at word " + std::to_string(*words->second.begin()));
    }
    std::size_t drawn() const { return drawn_; }

  private:
    std::map<std::pair<std::size_t, std::size_t>, std::set<std::uint64_t>> words_;
    std::size_t drawn_ = 0;
};

/// In the simulation's process: what it throws, test_run() throws.
void check_clearing(recording::RecordedWindow const& window) {
    std::map<std::size_t, DirtyWords> dirty;
    for_each_access(window.cores, [&](auto const& event, auto const& read, auto const& accesses) {
        DirtyWords& words = dirty[event.core];
        for (recording::PortAccess const& access : accesses)
            words.take(event.process, access);
        if (event.event.kind == recording::Event::Kind::read)
            for (BramId const bram : DirtyWords::drawn_next(fifo_ids.at(event.event.item)))
                words.give(bram, static_cast<std::size_t>(read.at(0)));
    });
    for (auto const& [core, words] : dirty)
        if (words.drawn() == 0)
            throw std::runtime_error("nothing was drawn");
}

/// A triangle in the window's upper left corner, none in the second and third sample.
Stimulus triangle_now_and_then(int window, int samples) {
    Stimulus stimulus = empty_stimulus(window, samples);
    stimulus.triangles = one_small_triangle().triangles;
    for (int i = 0; i < samples; ++i)
        stimulus.samples[static_cast<std::size_t>(i)].triangle_count = i == 1 || i == 2 ? 0 : 1;
    return stimulus;
}

TEST_CASE("Without triangles two buffers and a touched region take W^2 + 9 cycles per sample", "[double_buffers]") {
    // Edge map builder: cleared at T = W^2 + 2, End read, no tokens, the corners read at W^2 + 4 and W^2 + 5, map_full
    // written at W^2 + 6. map_free is read two cycles later, and clearing begins again: 9 cycles from map_full to
    // map_full beside those of the W^2 words. The inlier unit is a cycle faster, but its second corner is written when
    // the builder has read End. InlierSweep: depth_full written at W^2 + 5, read, no sweep, result at W^2 + 8.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (int const window : {5, 12, 33})
        for (int const samples : {1, 2, 3, 5}) {
            CAPTURE(engine, window, samples);
            auto const pixels = static_cast<Cycles>(window) * static_cast<Cycles>(window);
            RunStatistics const run =
                test_run(with_two_of_each(SweepRegion::touched), empty_stimulus(window, samples), engine).statistics;
            CHECK(run.total_cycles == pixels + 10 + static_cast<Cycles>(samples - 1) * (pixels + 9));
            for (SampleStatistics const& sample : run.samples)
                CHECK(counters_of(sample).valid_depth == static_cast<std::uint64_t>((window - 2) * (window - 2)));
        }
}

TEST_CASE("A region travels with its buffer, past samples that touch nothing", "[double_buffers][sweep_region]") {
    Stimulus const stimulus = triangle_now_and_then(24, 6);
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (MapClearing const clearing : {MapClearing::loop, MapClearing::on_read_out}) {
        CAPTURE(engine, static_cast<int>(clearing));
        AcceleratorConfig config = with_two_of_each(SweepRegion::touched);
        config.edge_map.clearing = config.inlier_unit.clearing = clearing;
        RunStatistics const run = test_run(config, stimulus, engine).statistics;
        config.inlier_unit.sweep_region = SweepRegion::window;
        config.edge_map.buffers = config.inlier_unit.buffers = 1;
        RunStatistics const plain = test_run(config, stimulus, engine).statistics;
        for (std::size_t i = 0; i < stimulus.samples.size(); ++i)
            CHECK(run.samples[i].counters == plain.samples[i].counters);
        auto const& loops = run.cores.at(0).loops;
        CHECK(loops[index_of(LoopId::buffered_output)].iterations == 4 * 4 * 4);
        CHECK(loops[index_of(LoopId::buffered_sweep)].entries == 4);
        CHECK(run.total_cycles < plain.total_cycles);
    }
}

TEST_CASE("What a module waits for when the last sample is over is not in its cycles", "[double_buffers]") {
    // The read-out waits for the maps of a sample that touches nothing, which are cleared first: its result does not
    // need them.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (int const samples : {2, 3})
        for (std::uint64_t const depth : {2U, 16U})
            for (MapClearing const clearing : {MapClearing::loop, MapClearing::on_read_out}) {
                CAPTURE(engine, samples, depth, static_cast<int>(clearing));
                AcceleratorConfig config = with_cores(1);
                config.inlier_unit.sweep_region = SweepRegion::touched;
                config.edge_map.buffers = 2;
                config.inlier_unit.clearing = clearing;
                config.fifo(FifoId::edge_token).depth = depth;
                Stimulus stimulus = triangle_now_and_then(24, samples);
                stimulus.triangles.front() = {{{16, 16, 16384}, {16, 96, 16384}, {96, 16, 16384}}};
                RunStatistics const run = test_run(config, stimulus, engine).statistics;
                for (std::size_t const i : modules_of(run.machine)) {
                    CAPTURE(module_ids[i].name);
                    ProcessStatistics const& process = run.cores.at(0).processes[i];
                    CHECK(process.sum() == run.total_cycles);
                    for (Cycles const cycles : process.cycles)
                        CHECK(cycles <= run.total_cycles);
                }
            }
}

TEST_CASE("What was drawn into a buffer is cleared before anybody draws there again", "[double_buffers]") {
    for (std::uint64_t seed = 21000; seed < 21040; ++seed) {
        CAPTURE(seed);
        Trial trial = trial_of(seed);
        trial.config.edge_map.clearing = trial.config.inlier_unit.clearing = MapClearing::on_read_out;
        for (LoopId const id : keyed_loop_ids)  // or a loop ends before the accesses of its last iteration
            trial.config.loop(id).depth = std::max<Cycles>(loop_of(trial.config, id).depth, 64);
        TestRunOptions options;
        options.recordings.push_back({recording::RecordingWindow{}, check_clearing});
        CHECK_NOTHROW(
            test_run(trial.config, trial.stimulus, seed % 2 == 0 ? Engine::decoupled : Engine::lockstep, options));
    }
}

TEST_CASE("What two buffers and a region would take is what a run takes", "[double_buffers][events]") {
    test::TempFolder const folder;
    for (std::uint64_t seed = 21100; seed < 21112; ++seed) {
        Trial const recorded = trial_of(seed);
        TestRunOptions options;
        options.events = folder / "events";
        REQUIRE_FALSE(
            test_run(recorded.config, recorded.stimulus, seed % 2 == 0 ? Engine::decoupled : Engine::lockstep, options)
                .statistics.deadlocked());
        events::EventFile const file = events::read_event_file(folder / "events");
        for (std::uint64_t other = seed + 100; other < seed + 108; ++other) {
            CAPTURE(seed, other);
            AcceleratorConfig config = trial_of(other).config;
            config.edge_map = recorded.config.edge_map;
            config.inlier_unit = recorded.config.inlier_unit;
            config.rasterizer = recorded.config.rasterizer;
            config.window = recorded.config.window;
            config.numbers = recorded.config.numbers;
            for (BramId const bram : bram_ids)
                config.memory(bram).partition = recorded.config.memory(bram).partition;
            RunStatistics const run = test_run(config, recorded.stimulus, Engine::decoupled).statistics;
            RunStatistics const retimed = replay::retime(file.run, raster_machine(config));
            REQUIRE(retimed.deadlocked() == run.deadlocked());
            CHECK((run.deadlocked() || first_difference(all_cells(retimed), all_cells(run)) == ""));
        }
    }
}

}  // namespace faster::testing::buffered_region_test
