#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>

#include "dataflow/run/figures/table_rows.hpp"
#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"
#include "support/random_stimulus.hpp"
#include "support/recorded_accesses.hpp"
#include "support/run_cells.hpp"
#include "support/small_stimulus.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing::hazards_test {

using Counts = std::vector<std::uint64_t>;
using PerDistance = std::map<std::uint64_t, std::uint64_t>;

TestRun run(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine = Engine::decoupled) {
    TestRunOptions options;
    options.with_maps = true;
    options.hazards = true;
    return test_run(config, stimulus, engine, options);
}

DependenceRow row_of(RunStatistics const& run, std::string const& loop, std::string const& bram) {
    for (DependenceRow const& row : dependence_sums(run))
        if (row.loop == loop && row.bram == bram)
            return row;
    throw std::runtime_error("no row of " + loop + " and " + bram);
}

/// One sample of triangles in an upper left corner each: (row, col) and two corners `size` pixels below and to the
/// right of it; z in 2^-14 m.
struct Corner {
    int row = 0;
    int col = 0;
    double size = 0.5;  ///< less than a pixel: covers one
    double metres = 1;
};

Stimulus triangles_at(std::vector<Corner> const& corners) {
    Stimulus stimulus = empty_stimulus(8, 1);
    for (Corner const& corner : corners) {
        auto const x = static_cast<std::int16_t>(16 * corner.col);
        auto const y = static_cast<std::int16_t>(16 * corner.row);
        auto const side = static_cast<std::int16_t>(16 * corner.size);
        auto const z = static_cast<std::uint16_t>(corner.metres * (1 << 14));
        stimulus.triangles.push_back(
            {{{x, y, z}, {x, static_cast<std::int16_t>(y + side), z}, {static_cast<std::int16_t>(x + side), y, z}}});
    }
    stimulus.samples[0].triangle_count = static_cast<std::uint32_t>(corners.size());
    return stimulus;
}

AcceleratorConfig flattened() {
    AcceleratorConfig config = with_cores(1);
    config.inlier_unit.fragment_loop = FragmentLoop::flattened;
    return config;
}

TEST_CASE("Triangles that share a pixel meet in one loop over all of them, not in a loop each", "[hazards]") {
    // Iterations: the first triangle's command, its fragment, the second's command, its fragment of the same pixel.
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    CAPTURE(engine);
    Stimulus const twice = triangles_at({{1, 1}, {1, 1, 0.5, 0.9}});
    DependenceRow const apart = row_of(run(with_cores(1), twice, engine).statistics, "fragment", "depth_buffer");
    CHECK(apart.smallest == 0);
    CHECK(apart.counts == Counts{0, 0, 0});
    DependenceRow const together = row_of(run(flattened(), twice, engine).statistics, "fragment", "depth_buffer");
    CHECK(together.smallest == 2);
    CHECK(together.counts == Counts{0, 0, 1});
    CHECK(together.hazards() == 1);
    AcceleratorConfig slower = flattened();
    slower.loop(LoopId::fragment).ii = 2;  // 2 x 2 cycles are no fewer than from stage 7 to 9
    DependenceRow const safe = row_of(run(slower, twice, engine).statistics, "fragment", "depth_buffer");
    CHECK(safe.counts == Counts{0, 0, 1});
    CHECK(safe.hazards() == 0);
    slower.loop(LoopId::fragment).ii = 1;
    slower.dependence("inlier_unit.fragment.depth_buffer").write_stage = 8;
    DependenceRow const shorter = row_of(run(slower, twice, engine).statistics, "fragment", "depth_buffer");
    CHECK(shorter.dependence.span() == 2);
    CHECK(shorter.hazards() == 0);
}

TEST_CASE("Two triangles that share an edge are as far apart as the fragments between", "[hazards]") {
    // Both have (1, 1), (1, 2) and (2, 1): a command and three fragments each, so every pixel comes again 4 later.
    DependenceRow const row =
        row_of(run(flattened(), triangles_at({{1, 1, 1}, {1, 1, 1, 0.9}})).statistics, "fragment", "depth_buffer");
    CHECK(row.smallest == 4);
    CHECK(row.hazards() == 0);
}

TEST_CASE("A fragment that is not drawn writes nothing", "[hazards]") {
    auto const counts_of = [](double second, double third) {
        Stimulus const stimulus = triangles_at({{1, 1}, {1, 1, 0.5, second}, {1, 1, 0.5, third}});
        return row_of(run(flattened(), stimulus).statistics, "fragment", "depth_buffer").counts;
    };
    CHECK(counts_of(0.9, 0.8) == Counts{0, 0, 2});
    CHECK(counts_of(1.1, 1.2) == Counts{0, 0, 1});  // the third is 4 iterations behind the first, which wrote last
}

TEST_CASE("A scan that turns at a wall below a covered pixel reads what it has just written", "[hazards]") {
    // Covered: row 1 from 1 to 3, row 2 from 1 to 2, row 3 at 1. Tokens: objects (1,1) (1,2) (1,3), edge (1,4), object
    // (2,2), edge (2,3), object (2,1), then at the left wall object (3,1), which looks at (2,1), and edge (3,2). Object
    // (2,1) is written in the iteration before.
    AcceleratorConfig config = with_cores(1);
    Stimulus const stimulus = triangles_at({{1, 1, 2}});
    RunStatistics const statistics = run(config, stimulus).statistics;
    DependenceRow const object = row_of(statistics, "token", "object_map");
    CHECK(object.dependence.span() == 2);
    CHECK(object.smallest == 1);
    CHECK(object.counts == Counts{0, 1});
    CHECK(object.hazards() == 1);
    DependenceRow const edge = row_of(statistics, "token", "edge_map");
    CHECK(edge.smallest == 1);   // (3,1) becomes an edge, then an object
    CHECK(edge.hazards() == 0);  // nobody reads it in this loop
    config.loop(LoopId::token).ii = 2;
    CHECK(row_of(run(config, stimulus).statistics, "token", "object_map").hazards() == 0);
    // Of a column of two pixels the upper one's right neighbour comes between.
    CHECK(row_of(run(with_cores(1), triangles_at({{1, 1, 1}})).statistics, "token", "object_map").hazards() == 0);
}

TEST_CASE("Designs with one map are saved by their recurrence", "[hazards]") {
    AcceleratorConfig config = with_cores(1);
    config.edge_map.algorithm = EdgeMapAlgorithm::bounded;
    DependenceRow const row = row_of(run(config, triangles_at({{1, 1, 2}})).statistics, "token", "edge_map");
    CHECK(row.ii >= 2);
    CHECK(row.counts[1] > 0);
    CHECK(row.hazards() == 0);
}

TEST_CASE("Forwarding is counted, and takes no time", "[hazards]") {
    AcceleratorConfig config = flattened();
    config.window = 8;
    Stimulus const twice = triangles_at({{1, 1}, {1, 1, 0.5, 0.9}});
    Cycles const total = run(config, twice).statistics.total_cycles;
    config.dependence("inlier_unit.fragment.depth_buffer").hazards = HazardHandling::forward;
    RunStatistics const statistics = run(config, twice).statistics;
    DependenceRow const row = row_of(statistics, "fragment", "depth_buffer");
    CHECK(statistics.total_cycles == total);
    CHECK(row.hazards() == 1);
    CHECK(row.comparators() == 2);                   // with the writes of the two iterations before
    CHECK(row.register_bits() == 2 * (6 + 11 + 1));  // address of 8 x 8 words, depth, valid
}

TEST_CASE("Looking for hazards changes nothing, in either engine", "[hazards]") {
    for (std::uint64_t seed = 30000; seed < 30036; ++seed) {
        CAPTURE(seed);
        RandomConfigOptions machine;
        machine.cores = {1, 3};
        machine.algorithm = static_cast<EdgeMapAlgorithm>(seed % 6);
        machine.any_scan = machine.any_clearing = true;
        machine.any_buffers = true;
        machine.max_scan_lanes = seed % 6 == 5 ? 4 : 1;  // inner_border
        RandomStimulusOptions work;
        work.window = {4, 24};
        AcceleratorConfig config = random_config(seed, machine);
        Stimulus const stimulus = random_stimulus(seed, work);
        adopt(stimulus, config);
        TestRunOptions options;
        options.with_maps = true;
        TestRun const without = test_run(config, stimulus, Engine::decoupled, options);
        TestRun const decoupled = run(config, stimulus);
        TestRun const lockstep = run(config, stimulus, Engine::lockstep);
        CHECK(first_difference(all_cells(decoupled.statistics), all_cells(without.statistics)) == "");
        for (std::size_t i = 0; i < without.maps.size(); ++i) {
            CHECK(decoupled.maps[i].edge_map == without.maps[i].edge_map);
            CHECK(decoupled.maps[i].depth_buffer == without.maps[i].depth_buffer);
        }
        std::vector<DependenceRow> const one = dependence_rows(decoupled.statistics);
        std::vector<DependenceRow> const other = dependence_rows(lockstep.statistics);
        CHECK(without.statistics.cores.at(0).dependences.empty());
        REQUIRE(one.size() == other.size());
        REQUIRE_FALSE(one.empty());
        for (std::size_t i = 0; i < one.size(); ++i) {
            CHECK(one[i].smallest == other[i].smallest);
            CHECK(one[i].counts == other[i].counts);
        }
    }
}

/// The distances of the token loop's accesses to a memory, from the addresses that a waveform shows, into a file: they
/// come from the tokens that go through the FIFOs. All writes of that memory have to happen whatever the data.
void note_distances(std::vector<recording::RecordedCore> const& cores, BramId bram, std::filesystem::path const& path) {
    using Kind = recording::Event::Kind;
    std::map<std::size_t, std::map<std::uint64_t, std::int64_t>> written;  // by core: iteration by word
    std::map<std::size_t, bool> in_token_loop;
    PerDistance seen;
    for_each_access(cores, [&](recording::CoreEvent const& event, auto const&, auto const& accesses) {
        if (event.process != index_of(ModuleId::edge_map_builder))
            return;
        if (event.event.kind == Kind::enter) {
            in_token_loop[event.core] = event.event.item == index_of(LoopId::token);
            written[event.core].clear();
        }
        if (event.event.kind != Kind::iterate || !in_token_loop[event.core])
            return;
        std::map<std::uint64_t, bool> words;  // touched, and whether written
        for (recording::PortAccess const& access : accesses)
            if (access.memory == index_of(bram))
                words[access.address] = words[access.address] || access.writes;
        for (auto const& [word, writes] : words) {
            auto const last = written[event.core].find(word);
            if (last != written[event.core].end())
                ++seen[static_cast<std::uint64_t>(event.event.value - last->second)];
            if (writes)
                written[event.core][word] = event.event.value;
        }
    });
    std::ofstream file(path);
    for (auto const& [distance, count] : seen)
        file << distance << ' ' << count << '\n';
}

PerDistance read_distances(std::filesystem::path const& path) {
    PerDistance distances;
    std::ifstream file(path);
    for (std::uint64_t distance = 0, count = 0; file >> distance >> count;)
        distances[distance] = count;
    return distances;
}

TEST_CASE("The addresses of a waveform have the same distances", "[hazards]") {
    test::TempFolder const folder;
    std::uint64_t met = 0;
    for (std::uint64_t seed = 30100; seed < 30124; ++seed) {
        EdgeMapAlgorithm const algorithm =
            std::array{EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2, EdgeMapAlgorithm::inner_border,
                       EdgeMapAlgorithm::threshold}[seed % 4];
        BramId const bram = algorithm == EdgeMapAlgorithm::threshold ? BramId::edge_map : BramId::object_map;
        RandomConfigOptions machine;
        machine.cores = {1, 2};
        machine.algorithm = algorithm;
        RandomStimulusOptions work;
        work.window = {4, 24};
        work.samples = {1, 5};
        AcceleratorConfig config = random_config(seed, machine);
        config.loop(LoopId::token).depth = 20;
        config.dependence(std::string("edge_map_builder.token.") + name_of(bram)).write_stage = 19;  // span of 18
        Stimulus const stimulus = random_stimulus(seed, work);
        adopt(stimulus, config);
        TestRunOptions options;
        options.hazards = true;
        options.recordings.push_back({recording::RecordingWindow{}, [&](recording::RecordedWindow const& recorded) {
                                          note_distances(recorded.cores, bram, folder / "distances");
                                      }});
        DependenceRow const row =
            row_of(test_run(config, stimulus, Engine::decoupled, options).statistics, "token", name_of(bram));
        PerDistance const expected = read_distances(folder / "distances");
        CAPTURE(seed, name_of(bram));
        CHECK(row.smallest == (expected.empty() ? 0 : expected.begin()->first));
        for (std::uint64_t distance = 1; distance < row.counts.size(); ++distance) {
            CAPTURE(distance);
            auto const found = expected.find(distance);
            CHECK(row.counts[distance] == (found == expected.end() ? 0 : found->second));
            met += row.counts[distance];
        }
    }
    CHECK(met > 500);
}

}  // namespace faster::testing::hazards_test
