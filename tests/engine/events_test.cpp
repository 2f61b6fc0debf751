#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>

#include "dataflow/base/files/zstd_frame.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/machine_json.hpp"
#include "dataflow/run/replay/canonical_operations.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/sample_codec.hpp"
#include "dataflow/run/replay/sample_cutter.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/run/replay/slack.hpp"
#include "dataflow/run/replay/tape_reader.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/run_cells.hpp"
#include "support/small_stimulus.hpp"
#include "support/spelled_out.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing::events_test {

using timing::Operation;
using timing::OperationLog;

/// Workloads of different kinds, small enough for many runs.
constexpr std::array<std::optional<TriangleKind>, 10> workload_kinds{std::nullopt,           TriangleKind::Tiny,
                                                                     TriangleKind::Small,    TriangleKind::Huge,
                                                                     TriangleKind::Sliver,   TriangleKind::BackFacing,
                                                                     TriangleKind::Border,   TriangleKind::WholePixels,
                                                                     TriangleKind::Rejected, std::nullopt};

Stimulus workload(std::size_t number) {
    RandomStimulusOptions options;
    options.width = {24, 48};
    options.height = {24, 48};
    options.window = {4, 16};
    options.samples = {1, 9};
    options.triangles = {0, 12};
    options.kind = workload_kinds[number];
    options.random_fraction_bits = number == 9;
    return random_stimulus(9000 + number, options);
}

/// With the function of a recorded run. Every third one may deadlock.
AcceleratorConfig configuration(std::uint64_t seed, AcceleratorConfig const& recorded) {
    RandomConfigOptions options;
    options.fifo_depth = {1, 24};
    options.is_deadlock_free = seed % 3 != 0;
    options.any_partition = true;
    options.any_region = true;
    options.any_buffers = true;  // for the depths of the FIFOs between them
    AcceleratorConfig config = random_config(seed, options);
    config.edge_map = recorded.edge_map;
    config.inlier_unit = recorded.inlier_unit;
    config.rasterizer = recorded.rasterizer;
    config.numbers = recorded.numbers;
    return config;
}

RunStatistics record(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                     std::filesystem::path const& file) {
    TestRunOptions options;
    options.events = file;
    return test_run(config, stimulus, engine, options).statistics;
}

/// A configuration that certainly finishes, on as many cores as a random one.
AcceleratorConfig recorded_configuration(std::uint64_t seed, std::size_t number) {
    AcceleratorConfig config;
    if (number % 2 == 1)
        config = random_config(seed);
    config.cores = 1 + seed % 5;
    config.edge_map.algorithm = static_cast<EdgeMapAlgorithm>(number % 6);
    config.edge_map.clearing = number % 3 == 0 ? MapClearing::on_read_out : MapClearing::loop;
    config.inlier_unit.clearing = number % 4 == 0 ? MapClearing::on_read_out : MapClearing::loop;
    config.inlier_unit.neighbour_access = number % 4 < 2 ? NeighbourAccess::window : NeighbourAccess::direct;
    config.inlier_unit.fragment_loop = number % 3 == 1 ? FragmentLoop::flattened : FragmentLoop::per_triangle;
    config.rasterizer.setup_overlap = number % 5 < 2 ? 0 : number % 5 - 1;
    if (config.edge_map.algorithm != EdgeMapAlgorithm::threshold)
        config.rasterizer.scan = static_cast<ScanPolicy>((number / 2) % 3);
    config.inlier_unit.sweep_lanes = 1 + static_cast<int>(number % 3);
    if (config.edge_map.algorithm == EdgeMapAlgorithm::inner_border) {
        config.rasterizer.edge_tokens = EdgeTokens::object;
        config.rasterizer.lanes = 2 + static_cast<int>(seed % 7);
    }
    config.inlier_unit.sweep_region = number % 4 < 2 ? SweepRegion::window : SweepRegion::touched;
    config.edge_map.buffers = 1 + static_cast<int>(number / 4 % 2);
    config.inlier_unit.buffers = 1 + static_cast<int>(number % 2);
    return config;
}

/// Equal in every figure; a deadlock in who waits for whom, where and since when.
void check_equal(RunStatistics const& retimed, RunStatistics const& run) {
    REQUIRE(retimed.deadlocked() == run.deadlocked());
    if (run.deadlocked()) {
        CHECK(first_difference(stuck_cells(retimed), stuck_cells(run)) == "");
        CHECK(first_difference(position_cells(retimed), position_cells(run)) == "");
        CHECK(retimed.deadlock_cycle() == run.deadlock_cycle());
        return;
    }
    CHECK(first_difference(all_cells(retimed), all_cells(run)) == "");
}

/// A small run's event file.
std::filesystem::path small_file(test::TempFolder const& folder) {
    std::filesystem::path file = folder / "events";
    record(AcceleratorConfig(), workload(0), Engine::decoupled, file);
    return file;
}

/// The samples of a file.
struct Samples {
    explicit Samples(events::EventFile const& its_file)
        : file(its_file),
          machine(raster_machine(accelerator_of(file.loaded.config))),
          cutter(*file.run.blueprint, machine.lead),
          tape(file.run.tape, replay::LeadCore(*file.run.blueprint, machine.lead)),
          known(replay::LeadCore(*file.run.blueprint, machine.lead)) {}

    std::size_t count() const { return file.run.tape.samples(); }
    replay::SampleOperations operations(std::size_t sample) {
        return replay::joined(tape.read(sample), tape.known().book(), tape.known().lead().group);
    }
    /// What the frame of a sample holds.
    std::string content(std::size_t sample) const {
        replay::OperationTape::Bytes frame;
        file.run.tape.read_block(sample, frame);
        return *io::content_of_zstd_frame({frame.data(), frame.size()}, file.run.tape.blocks()[sample].content_bytes);
    }
    /// A run of one sample, whatever comes of it.
    RunStatistics retime(replay::ScriptedSample const& sample) const {
        replay::RecordedRun run;
        run.blueprint = file.run.blueprint->blank_copy();
        run.lead = machine.lead;
        run.counters.resize(1);
        run.tape.put(0, sample, known.book());
        run.tape.finish();
        return replay::retime(run, machine);
    }
    bool can_do(replay::SampleOperations const& operations) const {
        for (std::size_t i = 0; i < operations.size(); ++i) {
            replay::OperationCheck check(known.lead().core->processes()[i]);
            for (Operation const& operation : operations[i])
                if (!check.accepts(operation))
                    return false;
            if (!check.is_done())
                return false;
        }
        return true;
    }

    events::EventFile const& file;
    Machine machine;
    replay::SampleCutter cutter;
    replay::TapeReader tape;
    replay::KnownPhrases known;
};

/// All operations of a file, read back; InputError if anything is wrong with it.
std::string content_of_events(std::filesystem::path const& path) {
    events::EventFile const file = events::read_event_file(path);
    Samples samples(file);
    std::string content = file.summary;
    for (std::size_t i = 0; i < samples.count(); ++i)
        for (std::vector<Operation> const& process : samples.operations(i))
            for (Operation const& operation : process)
                content += std::to_string(operation.code()) + ' ';
    return content;
}

std::vector<Operation> canonical_of(OperationLog const& log) { return replay::canonical(log.begin(), log.pending()); }

std::vector<Operation::Code> said_by(std::vector<Operation> const& operations) {
    OperationLog log;
    for (Operation const& operation : operations)
        log.append(operation);
    return spelled_out(log);
}

std::vector<Operation::Code> codes_of(std::vector<Operation> const& operations) {
    std::vector<Operation::Code> codes;
    codes.reserve(operations.size());
    for (Operation const& operation : operations)
        codes.push_back(operation.code());
    return codes;
}

TEST_CASE("What a recorded run would take is what a run takes, in every figure", "[events]") {
    test::TempFolder const folder;
    std::size_t deadlocks = 0;
    for (std::size_t number = 0; number < workload_kinds.size(); ++number) {
        Stimulus const stimulus = workload(number);
        AcceleratorConfig const recorded = recorded_configuration(9100 + number, number);
        Engine const engine = number % 2 == 0 ? Engine::decoupled : Engine::lockstep;
        record(recorded, stimulus, engine, folder / "events");
        events::EventFile const file = events::read_event_file(folder / "events");
        replay::ScriptedRun const scripted(file.run);
        for (std::uint64_t i = 0; i < 20; ++i) {
            std::uint64_t const seed = 10000 + 100 * number + i;
            CAPTURE(number, seed);
            AcceleratorConfig const config = configuration(seed, recorded);
            RunStatistics const run = test_run(config, stimulus, Engine::decoupled).statistics;
            {
                INFO("without scripts");
                check_equal(replay::retime_unscripted(scripted, raster_machine(config)), run);
            }
            {
                INFO("from scripts");
                check_equal(replay::retime(scripted, raster_machine(config)), run);
            }
            {
                INFO("on several threads");
                check_equal(replay::retime(scripted, raster_machine(config), 2 + i % 3), run);
            }
            deadlocks += run.deadlocked() ? 1U : 0U;
        }
    }
    CHECK(deadlocks > 8);
    CHECK(deadlocks < 100);
}

TEST_CASE("Samples that are put into steps take what a run takes, whatever the depths and intervals", "[events]") {
    test::TempFolder const folder;
    std::size_t deadlocks = 0;
    for (std::size_t number = 0; number < 4; ++number) {
        AcceleratorConfig recorded = recorded_configuration(9800 + number, 0);
        recorded.rasterizer.setup_overlap = 1 + number;
        Stimulus const stimulus = workload(number);
        record(recorded, stimulus, Engine::decoupled, folder / "events");
        events::EventFile const file = events::read_event_file(folder / "events");
        replay::ScriptedRun const scripted(file.run);
        for (std::uint64_t i = 0; i < 30; ++i) {
            std::uint64_t const seed = 30000 + 100 * number + i;
            CAPTURE(number, seed);
            AcceleratorConfig const random = configuration(seed, recorded);
            AcceleratorConfig config = i % 2 == 0 ? random : recorded;  // with other forms, or not
            config.cores = random.cores;
            for (FifoId const id : fifo_ids)
                config.fifo(id) = random.fifo(id);
            RunStatistics const run = test_run(config, stimulus, Engine::decoupled).statistics;
            check_equal(replay::retime(scripted, raster_machine(config), 1 + i % 2), run);
            deadlocks += run.deadlocked() ? 1U : 0U;
        }
    }
    CHECK(deadlocks > 0);
    CHECK(deadlocks < 80);
}

TEST_CASE("A run that is recorded takes the time that it takes without", "[events]") {
    test::TempFolder const folder;
    std::size_t deadlocks = 0;
    for (std::size_t number = 0; number < workload_kinds.size(); ++number) {
        Stimulus const stimulus = workload(number);
        AcceleratorConfig const base = recorded_configuration(9700 + number, number);
        for (std::uint64_t i = 0; i < 5; ++i) {
            std::uint64_t const seed = 20000 + 100 * number + i;
            CAPTURE(number, seed);
            AcceleratorConfig const config = configuration(seed, base);
            RunStatistics const run = test_run(config, stimulus, Engine::decoupled).statistics;
            check_equal(record(config, stimulus, Engine::decoupled, folder / "events"), run);
            deadlocks += run.deadlocked() ? 1U : 0U;
        }
    }
    CHECK(deadlocks > 2);
    CHECK(deadlocks < 20);
}

TEST_CASE("On how many threads a run is read does not matter", "[events]") {
    test::TempFolder const folder;
    auto const said_by_phrases = [](replay::ScriptedRun const& run) {
        std::vector<Operation::Code> said;
        for (std::size_t i = 0; i < run.size(); ++i)
            for (timing::PhraseBook::Number const number : run[i].phrases)
                said.insert(said.end(), run.book().codes(number), run.book().codes(number) + run.book()[number].size);
        return said;
    };
    for (std::size_t number = 0; number < 4; ++number) {
        AcceleratorConfig const recorded = recorded_configuration(9600 + number, number);
        record(recorded, workload(number), Engine::decoupled, folder / "events");
        events::EventFile const file = events::read_event_file(folder / "events");
        replay::ScriptedRun const one(file.run, replay::ScriptedRun::Uses::many, 1);
        CHECK(one.size() == file.samples.size());
        for (std::size_t const jobs : {2U, 3U, 20U}) {
            CAPTURE(number, jobs);
            replay::ScriptedRun const run(file.run, replay::ScriptedRun::Uses::many, jobs);
            CHECK(run.size() == file.samples.size());
            CHECK(said_by_phrases(run) == said_by_phrases(one));
        }
    }
}

TEST_CASE("Both engines write the same event file", "[events]") {
    test::TempFolder const folder;
    for (std::size_t number = 0; number < workload_kinds.size(); ++number) {
        CAPTURE(number);
        AcceleratorConfig const config = recorded_configuration(9200 + number, number);
        record(config, workload(number), Engine::decoupled, folder / "a");
        record(config, workload(number), Engine::lockstep, folder / "b");
        CHECK(test::content_of(folder / "a") == test::content_of(folder / "b"));
    }
}

TEST_CASE("An event file knows its run", "[events]") {
    test::TempFolder const folder;
    AcceleratorConfig const config = random_config(9300);
    RunStatistics const run = record(config, workload(0), Engine::lockstep, folder / "events");
    events::EventFile const file = events::read_event_file(folder / "events");
    check_equal(replay::retime(file.run, raster_machine(accelerator_of(file.loaded.config))), run);
    REQUIRE(file.samples.size() == run.samples.size());
    for (std::size_t i = 0; i < run.samples.size(); ++i) {
        CHECK(file.samples[i].end_cycle == run.samples[i].end_cycle);
        CHECK(file.samples[i].counters == run.samples[i].counters);
    }
}

TEST_CASE("What stands where in the source is known from the first core that got there", "[events]") {
    Stimulus stimulus = one_small_triangle();
    stimulus.samples.insert(stimulus.samples.begin(), stimulus.samples[0]);
    stimulus.samples[0].triangle_count = 0;  // that of core 0, if there are two
    auto const lines_with = [&stimulus](std::uint64_t cores) {
        test::TempFolder const folder;
        record(with_cores(cores), stimulus, Engine::decoupled, folder / "events");
        events::EventFile const file = events::read_event_file(folder / "events");
        std::vector<unsigned> lines;
        for (timing::ProcessTiming const& process : file.run.blueprint->processes()) {
            for (unsigned loop = 0; loop < process.loops().size(); ++loop)
                lines.push_back(process.loop_site(loop).line);
            for (unsigned port = 0; port < process.port_count(); ++port)
                lines.push_back(process.port_site(port).line);
        }
        return lines;
    };
    CHECK(lines_with(2) == lines_with(1));
}

TEST_CASE("A run that deadlocks leaves no event file", "[events]") {
    test::TempFolder const folder;
    AcceleratorConfig config;
    config.fifo(FifoId::fragment_depth).depth = 1;
    CHECK(record(config, workload(0), Engine::decoupled, folder / "events").deadlocked());
    CHECK(test::entries_in(folder.path()) == 0);
}

TEST_CASE("An event file that is cut off anywhere is refused", "[events]") {
    test::TempFolder const folder;
    std::string const bytes = test::content_of(small_file(folder));
    for (std::size_t part = 0; part < 200; ++part) {
        CAPTURE(part);
        auto const cut = folder.write("cut", bytes.substr(0, part * bytes.size() / 200));
        CHECK_THROWS_AS(content_of_events(cut), InputError);
    }
}

TEST_CASE("An event file with a wrong byte is refused, or still says the same", "[events]") {
    test::TempFolder const folder;
    auto const original = small_file(folder);
    std::string const bytes = test::content_of(original);
    std::string const content = content_of_events(original);
    std::size_t refused = 0;
    for (std::size_t part = 0; part < 400; ++part) {
        std::string changed = bytes;
        std::size_t const at = part * bytes.size() / 400;
        changed[at] = static_cast<char>(changed[at] ^ (1 << (part % 8)));
        auto const path = folder.write("changed", changed);
        bool is_same = false;
        try {
            is_same = content_of_events(path) == content;  // zstd ignores a bit of each frame
        } catch (InputError const&) {
            ++refused;
            continue;
        }
        CHECK(is_same);
    }
    CHECK(refused > 390);
}

TEST_CASE("Operations that are cut into phrases and joined again say the same", "[events]") {
    test::TempFolder const folder;
    for (std::size_t number = 0; number < workload_kinds.size(); ++number) {
        record(recorded_configuration(9400 + number, number), workload(number), Engine::decoupled, folder / "events");
        events::EventFile const file = events::read_event_file(folder / "events");
        Samples samples(file);
        for (std::size_t i = 0; i < samples.count(); ++i) {
            replay::SampleOperations const operations = samples.operations(i);
            replay::ScriptedSample const cut = samples.cutter.cut(operations);
            replay::SampleOperations const joined =
                replay::joined(cut, samples.cutter.book(), samples.known.lead().group);
            for (std::size_t process = 0; process < operations.size(); ++process) {
                CAPTURE(number, i, process);
                CHECK(said_by(joined[process]) == said_by(operations[process]));
            }
        }
    }
}

TEST_CASE("A sample that says what no process can do is refused", "[events]") {
    test::TempFolder const folder;
    std::mt19937_64 random(9500);
    std::size_t refused = 0;
    std::size_t accepted = 0;
    for (std::size_t number = 0; number < workload_kinds.size(); ++number) {
        record(recorded_configuration(9500 + number, number), workload(number), Engine::decoupled, folder / "events");
        events::EventFile const file = events::read_event_file(folder / "events");
        Samples samples(file);
        std::string const content = samples.content(0);
        for (std::size_t i = 0; i < 1000; ++i) {
            std::size_t const at = random() % content.size();
            unsigned const flip = 1U << (random() % 8);
            CAPTURE(number, at, flip);
            std::string changed = content;
            changed[at] = static_cast<char>(static_cast<unsigned char>(changed[at]) ^ flip);
            replay::ScriptedSample read;
            if (!replay::decode(changed, samples.known, read)) {
                ++refused;
                continue;
            }
            ++accepted;
            CHECK(samples.can_do(replay::joined(read, samples.known.book(), samples.known.lead().group)));
            if (accepted % 4 == 0)
                CHECK_NOTHROW(samples.retime(read));
        }
    }
    CHECK(refused > 1000);
    CHECK(accepted > 1000);
}

TEST_CASE("A sample that goes on with what is not its own is refused", "[events]") {
    test::TempFolder const folder;
    events::EventFile const file = events::read_event_file(small_file(folder));
    Samples samples(file);
    replay::ScriptedSample original;
    REQUIRE(replay::decode(samples.content(0), samples.known, original));
    auto const is_refused = [&](auto change) {
        replay::ScriptedSample changed = original;
        change(changed);
        replay::ScriptedSample read;
        return !replay::decode(replay::encode(changed, samples.known.book()), samples.known, read);
    };
    CHECK_FALSE(is_refused([](replay::ScriptedSample&) {}));
    CHECK(is_refused([](replay::ScriptedSample& sample) {  // the supplier is never behind the others
        std::size_t const supplier = index_of(ModuleId::vertex_transform);
        REQUIRE_FALSE(sample.before[supplier].empty());
        sample.after[supplier].push_back(sample.before[supplier].back());
        sample.before[supplier].pop_back();
    }));
    for (unsigned const ports : {0x20U, 0x80U})
        for (unsigned member = 0; member < 5; ++member) {
            CAPTURE(member, ports);
            CHECK(is_refused([&](replay::ScriptedSample& sample) {
                sample.script.next_ports[member] = static_cast<std::uint8_t>(ports);
            }));
        }
}

TEST_CASE("A machine that no core is like is refused", "[events]") {
    test::TempFolder const folder;
    events::EventFile const file = events::read_event_file(small_file(folder));
    Machine const recorded = raster_machine(accelerator_of(file.loaded.config));
    Json const machine = events::machine_json(*file.run.blueprint);
    auto const read = [&recorded](Json const& changed) {
        replay::RecordedRun run;
        events::read_machine(changed, recorded, run);
    };
    CHECK_NOTHROW(read(machine));
    auto const refused = [&](auto change) {
        Json changed = machine;
        change(changed);
        CHECK_THROWS_AS(read(changed), std::invalid_argument);
    };
    refused([](Json& all) { all.erase(all.size() - 1); });
    refused([](Json& all) { std::swap(all[0], all[1]); });
    refused([](Json& all) { all[1]["ports"][0]["fifo"] = "result"; });
    refused([](Json& all) { all[1]["ports"][0]["fifo"] = "nothing"; });
    refused([](Json& all) { all[1]["ports"][0]["access"] = "write"; });
    refused([](Json& all) { all[1]["ports"].push_back(all[1]["ports"][0]); });
    refused([](Json& all) { all[1]["loops"][0]["loop"] = "sweep"; });
    refused([](Json& all) { all[1]["loops"][0]["writes"].push_back(7); });
}

TEST_CASE("How many iterations a process tells at once does not matter to what is recorded", "[events]") {
    for (unsigned pattern = 1; pattern < 200; ++pattern) {
        CAPTURE(pattern);
        OperationLog whole;
        OperationLog single;
        for (OperationLog* log : {&whole, &single}) {
            log->wait(1);
            log->enter(0);
        }
        for (unsigned i = 0; i < 5; ++i) {
            std::uint32_t const gaps = pattern * 2654435761U * (i + 1);
            unsigned const length = 1 + (pattern + 7 * i) % 32;
            std::uint32_t const used = gaps & Operation::gap_bits(1, length);
            whole.iterate_mixed(1, length, used);
            for (unsigned bit = 0; bit < length; ++bit)
                single.iterate_mixed(1, 1, (used >> bit) & 1U);
            whole.iterate(1, pattern & 1U, 10 * pattern);
            for (unsigned left = 10 * pattern; left > 0; --left)
                single.iterate(1, pattern & 1U, 1);
        }
        whole.leave();
        single.leave();
        CHECK(codes_of(canonical_of(whole)) == codes_of(canonical_of(single)));
    }
}

TEST_CASE("A key's slack is the largest change that costs nothing", "[events]") {
    test::TempFolder const folder;
    Stimulus const stimulus = workload(0);
    RunStatistics const recorded = record(AcceleratorConfig(), stimulus, Engine::decoupled, folder / "events");
    events::EventFile const file = events::read_event_file(folder / "events");
    std::vector<Sensitivity> rows = replay::sensitivities(file.run, file.loaded);
    replay::find_slack(file.run, file.loaded, recorded.total_cycles, rows);
    Keys const keys = timing_keys(file.loaded.config);
    auto const costs = [&](std::size_t i, std::int64_t value) {
        RunConfig config = file.loaded.config;
        keys[i].write(config, KeyValue{value});
        RunStatistics const run = replay::retime(file.run, raster_machine(accelerator_of(config)));
        return run.deadlocked() || run.total_cycles > recorded.total_cycles;
    };
    std::size_t found = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (auto const& [direction, step] : {std::make_pair(-1, rows[i].down), std::make_pair(1, rows[i].up)}) {
            CAPTURE(rows[i].key, direction);
            REQUIRE(step.slack);
            std::int64_t const change = step.slack->change;
            CHECK(change <= replay::most_slack);
            CHECK_FALSE(costs(i, rows[i].value + direction * change));
            if (step.slack->end == SlackEnd::costs)
                CHECK(costs(i, rows[i].value + direction * (change + 1)));
            if (step.slack->end == SlackEnd::limit)
                CHECK(change == replay::most_slack);
            found += change > 0 && step.slack->end == SlackEnd::costs ? 1U : 0U;
        }
    CHECK(found > 0);
}

}  // namespace faster::testing::events_test
