#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/trace.hpp"
#include "support/command.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"
#include "tb/cosim/comparison.hpp"

namespace faster::testing::cosimulation_test {

std::string const source = FASTER_SOURCE_DIR;

/// What the model does, as `config` says, that the twin does not, as `settings` say; empty: nothing.
std::string difference(AcceleratorConfig const& config, rtl::TwinSettings const& settings, Stimulus const& stimulus) {
    std::string const unequal = "differs in cycle ";
    KeptMaps maps;
    TestRunOptions options;
    options.probe = &maps;
    auto const compare = [&](recording::RecordedWindow const& window) {
        for (recording::RecordedCore const& core : window.cores) {
            CoreShare const share = share_of(core.core, config.cores, stimulus.samples.size());
            auto const found = rtl::compare(core, maps, settings, stimulus, share).difference;
            if (found)
                throw std::runtime_error(unequal + std::to_string(found->cycle) + ": " + found->what);
        }
    };
    options.recordings.push_back({{}, compare});
    try {
        test_run(config, stimulus, Engine::decoupled, options);
    } catch (std::runtime_error const& error) {
        std::string const what = error.what();
        if (what.find(unequal) == std::string::npos)
            throw;
        return what.substr(what.find(unequal));
    }
    return {};
}

rtl::TwinSettings settings_of(AcceleratorConfig const& config, Stimulus const& stimulus) {
    return rtl::twin_settings(config, raster_machine(config), stimulus.width, stimulus.height);
}

std::string difference(AcceleratorConfig const& config, AcceleratorConfig const& twin, Stimulus const& stimulus) {
    return difference(config, settings_of(twin, stimulus), stimulus);
}

/// As the model reports them.
std::uint64_t hazards_of(AcceleratorConfig const& config, Stimulus const& stimulus) {
    TestRunOptions options;
    options.hazards = true;
    std::uint64_t hazards = 0;
    for (DependenceRow const& row : dependence_sums(test_run(config, stimulus, Engine::decoupled, options).statistics))
        hazards += row.hazards();
    return hazards;
}

/// Brings what random_config() draws to where the twin has places and stages for it.
void fit_to_twin(AcceleratorConfig& config, std::mt19937_64& random) {
    for (FifoId const id : fifo_ids)
        if (auto const at = config.fifos.find(id); at != config.fifos.end() && at->second.depth)
            at->second.depth = std::min<std::uint64_t>(*at->second.depth, 64);
    auto const at_least = [&config](LoopId loop, Cycles depth) {
        config.loop(loop).depth = std::max(depth, config.loop(loop).depth.value_or(1));
    };
    at_least(LoopId::token, 2);
    at_least(LoopId::output, 2);
    at_least(LoopId::fragment, 3);
    at_least(LoopId::sweep, 6);
    for (FifoId const id : {FifoId::edge_map, FifoId::area_reciprocal}) {
        Cycles& latency = *config.fifo(id).write_latency;
        latency = std::max<Cycles>(latency, 1);
    }
    config.fifo_rules = static_cast<FifoGeneration>(random() % 3);
    if (config.edge_map.algorithm == EdgeMapAlgorithm::inner_border && random() % 2 == 0)
        config.rasterizer.edge_tokens = EdgeTokens::object;
    config.inlier_unit.fragment_loop = static_cast<FragmentLoop>(random() % 2);
}

struct Trial {
    AcceleratorConfig config;
    Stimulus stimulus;
};

Trial random_trial(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    RandomStimulusOptions stimulus;
    stimulus.width = {24, 64};
    stimulus.height = {24, 64};
    stimulus.window = {2, 24};
    stimulus.samples = {0, 6};
    stimulus.random_fraction_bits = seed % 3 == 0;
    RandomConfigOptions config;
    config.cores = {1, 3};
    config.max_ports = 6;
    config.any_clearing = seed % 2 == 0;
    config.algorithm = seed % 4 < 2 ? EdgeMapAlgorithm::dual_map : EdgeMapAlgorithm::inner_border;
    config.is_deadlock_free = seed % 5 != 0;
    Trial trial{random_config(seed, config), random_stimulus(seed, stimulus)};
    trial.config.inlier_unit.hidden = seed % 7 < 3 ? HiddenPixels::counted : HiddenPixels::ignored;
    fit_to_twin(trial.config, random);
    adopt(trial.stimulus, trial.config);
    trial.config.fraction_bits = trial.stimulus.fraction;
    return trial;
}

/// Makes a design of the twin with lanes of it. Columns are in so many banks that every lane has its own.
void give_lanes(AcceleratorConfig& config, std::mt19937_64& random) {
    auto const draw = [&random](std::uint64_t first, std::uint64_t last) {
        return first + random() % (last - first + 1);
    };
    std::uint64_t const banks = draw(1, 10);
    auto const draw_lanes = [&] {
        std::uint64_t lanes = draw(1, banks);
        while (banks % lanes != 0)
            --lanes;
        return static_cast<int>(lanes);
    };
    config.rasterizer.lanes = draw_lanes();
    config.inlier_unit.sweep_lanes = draw_lanes();
    for (BramId const id : {BramId::object_map, BramId::depth_buffer})
        config.memory(id).partition = {PartitionType::cyclic, banks, 2};
    config.edge_map.algorithm = EdgeMapAlgorithm::inner_border;
    config.edge_map.clearing = config.inlier_unit.clearing = MapClearing::on_read_out;
    config.rasterizer.scan = ScanPolicy::spans;
    config.rasterizer.edge_tokens = EdgeTokens::object;
    config.rasterizer.setup_overlap = draw(1, random() % 2 == 0 ? 3 : 16);
    config.inlier_unit.fragment_loop = FragmentLoop::flattened;
    config.inlier_unit.sweep_region = static_cast<SweepRegion>(draw(0, 1));
    config.edge_map.buffers = static_cast<int>(draw(1, 2));
    config.inlier_unit.buffers = static_cast<int>(draw(1, 2));
    for (FifoId const id : {FifoId::region, FifoId::valid_depth, FifoId::map_full, FifoId::map_free, FifoId::depth_full,
                            FifoId::depth_free})
        config.fifo(id).depth = draw(1, 4);
    std::optional<Cycles>& setup = config.setup("rasterizer");
    setup = std::max<Cycles>(*setup, 6);
    FifoSettings& area = config.fifo(FifoId::area);  // it leaves at once, its command when it has passed the loop
    if (random() % 8 != 0)
        area.depth = std::max(area.depth.value_or(2), config.loop(LoopId::scan).depth.value_or(8));
}

Trial random_lane_trial(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    RandomStimulusOptions stimulus;
    stimulus.width = {24, 64};
    stimulus.height = {24, 64};
    stimulus.window = {10, 32};
    stimulus.samples = {0, 6};
    stimulus.random_fraction_bits = seed % 3 == 0;
    RandomConfigOptions config;
    config.cores = {1, 2};
    config.max_ports = 3;
    config.algorithm = EdgeMapAlgorithm::inner_border;
    config.is_deadlock_free = seed % 5 != 0;
    Trial trial{random_config(seed, config), random_stimulus(seed, stimulus)};
    trial.config.inlier_unit.hidden = seed % 7 < 3 ? HiddenPixels::counted : HiddenPixels::ignored;
    give_lanes(trial.config, random);
    fit_to_twin(trial.config, random);
    trial.config.rasterizer.edge_tokens = EdgeTokens::object;
    trial.config.inlier_unit.fragment_loop = FragmentLoop::flattened;
    adopt(trial.stimulus, trial.config);
    trial.config.fraction_bits = trial.stimulus.fraction;
    return trial;
}

/// A reciprocal unit that squeezes, with little room behind it and much beside it: areas wait for a place.
Trial squeezed(Trial trial, std::uint64_t seed) {
    FifoSettings& reciprocals = trial.config.fifo(FifoId::area_reciprocal);
    reciprocals.when_full = WhenFull::squeeze;
    reciprocals.depth = 1 + seed % 2;
    reciprocals.write_latency = 1 + seed % 5;
    for (FifoId const id : {FifoId::command, FifoId::fragment_depth, FifoId::fragment_index, FifoId::edge_token}) {
        trial.config.fifo(id).depth = 400;
        trial.config.fifo(id).kind = FifoKind::memory;
    }
    return trial;
}
Trial squeezed_trial(std::uint64_t seed) { return squeezed(random_trial(seed), seed); }
Trial squeezed_lane_trial(std::uint64_t seed) { return squeezed(random_lane_trial(seed), seed); }

void check_seeds(Trial (*random)(std::uint64_t), std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CAPTURE(seed);
        Trial const trial = random(seed);
        CHECK(difference(trial.config, trial.config, trial.stimulus) == "");
    }
}

/// A design on a trace of the repository, one core, with keys changed.
AcceleratorConfig config_with(std::string const& trace, std::vector<std::string> keys,
                              std::string const& architecture = "faster") {
    keys.push_back("workload.trace=" + source + "/traces/" + trace);
    keys.emplace_back("accelerator.raster_cores=1");
    keys.emplace_back("accelerator.memory.model=ideal");
    LoadedConfig loaded = layered_config({source + "/configs/architectures/" + architecture + ".yaml"}, keys);
    Stimulus const stimulus = files::read_trace(source + "/traces/" + trace);
    adopt(stimulus, accelerator_of(loaded.config));
    accelerator_of(loaded.config).fraction_bits = stimulus.fraction;
    return accelerator_of(loaded.config);
}

/// FIFOs that are written and read beside another one: alone, another kind of theirs changes no access.
bool is_beside_another(FifoId id) {
    return id == FifoId::fragment_depth || id == FifoId::fragment_index || id == FifoId::observed_depth ||
           id == FifoId::observed_edge;
}

using Mutation = std::vector<std::string>;

/// One change each of everything that decides when or what, as the model would have it by mistake.
std::vector<Mutation> mutations() {
    std::vector<Mutation> all;
    for (FifoId const id : fifo_ids) {
        if (FifoId::result < id)
            break;
        std::string const fifo = std::string("accelerator.fifos.") + id.name;
        if (!is_beside_another(id))
            all.push_back({fifo + ".kind=memory"});
        if (Cycles const latency = default_write_latency(id); latency > 0)
            all.push_back({fifo + ".write_latency=" + std::to_string(latency - 1)});
    }
    for (LoopId const id : keyed_loop_ids) {
        if (LoopId::sweep < id || id == LoopId::extract)
            continue;
        std::string const loop = std::string("accelerator.loops.") + id.module.name + "." + id.name;
        // The target of a sweep with five accesses and two ports does not matter up to 3.
        // Fragments come every other cycle.
        bool const is_slow = id == LoopId::sweep || id == LoopId::fragment;
        all.push_back({loop + (is_slow ? ".ii=4" : ".ii=2")});
        all.push_back({loop + ".depth=" + std::to_string(default_depth(id) + 1)});
    }
    for (char const* const more : {"loops.rasterizer.setup.depth=11",
                                   "brams.edge_map.ports=1",
                                   "brams.object_map.ports=1",
                                   "brams.depth_buffer.ports=1",
                                   "brams.depth_buffer.ports=3",
                                   "fifos.command.depth=3",
                                   "fifos.fragment_depth.depth=1",
                                   "fifos.fragment_index.depth=1",
                                   "fifos.edge_token.depth=1",
                                   "edge_map.algorithm=inner_border",
                                   "edge_map.clearing=on_read_out",
                                   "inlier_unit.clearing=on_read_out",
                                   "inlier_unit.neighbour_access=window",
                                   "rasterizer.scan=early_exit",
                                   "rasterizer.setup_overlap=1",
                                   "inlier_unit.fragment_loop=flattened",
                                   "edge_map.algorithm=transition",
                                   "edge_map.algorithm=bounded",
                                   "edge_map.algorithm=dual_map_4_1_2",
                                   "modules.area_reciprocal.interval=64"})
        all.push_back({std::string("accelerator.") + more});
    all.push_back({"accelerator.fifos.fragment_depth.kind=memory", "accelerator.fifos.fragment_index.kind=memory"});
    all.push_back({"accelerator.fifos.observed_depth.kind=memory", "accelerator.fifos.observed_edge.kind=memory"});
    return all;
}

TEST_CASE("Each of many mutations of the model is found", "[rtl]") {
    Stimulus const stimulus = files::read_trace(source + "/traces/edge_heavy");
    AcceleratorConfig const twin = config_with("edge_heavy", {});
    REQUIRE(difference(twin, twin, stimulus) == "");
    std::vector<Mutation> const all = mutations();
    REQUIRE(all.size() >= 50);
    for (Mutation const& mutation : all) {
        CAPTURE(mutation);
        CHECK(difference(config_with("edge_heavy", mutation), twin, stimulus) != "");
    }
}

TEST_CASE("Each of many mutations of a design with lanes is found", "[rtl]") {
    Stimulus const stimulus = files::read_trace(source + "/traces/edge_heavy");
    AcceleratorConfig const twin = config_with("edge_heavy", {}, "next_zcu102");
    REQUIRE(difference(twin, twin, stimulus) == "");
    for (char const* const key : {"rasterizer.setup_overlap=11",
                                  "rasterizer.lanes=5",
                                  "rasterizer.scan=early_exit",
                                  "inlier_unit.sweep_lanes=10",
                                  "inlier_unit.sweep_region=window",
                                  "inlier_unit.buffers=1",
                                  "edge_map.buffers=1",
                                  "inlier_unit.clearing=loop",
                                  "edge_map.clearing=wide",
                                  "inlier_unit.fragment_loop=per_triangle",
                                  "loops.rasterizer.setup.depth=99",
                                  "loops.rasterizer.scan.ii=2",
                                  "loops.rasterizer.scan.depth=9",
                                  "loops.inlier_unit.fragment.ii=2",
                                  "loops.inlier_unit.sweep.depth=9",
                                  "loops.edge_map_builder.output.ii=2",
                                  "brams.depth_buffer.partition.factor=5",
                                  "brams.object_map.ports=1",
                                  "brams.depth_buffer.ports=1",
                                  "modules.area_reciprocal.interval=64",
                                  "fifos.map_full.kind=memory",
                                  "fifos.depth_full.kind=memory",
                                  "fifos.region.kind=memory",
                                  "fifos.map_free.kind=memory",
                                  "fifos.depth_free.kind=memory",
                                  "fifos.fragment_depth.write_latency=6"}) {
        CAPTURE(key);
        CHECK(difference(config_with("edge_heavy", {std::string("accelerator.") + key}, "next_zcu102"), twin,
                         stimulus) != "");
    }
}

TEST_CASE("Without forwarding the twin is wrong only where the model reports hazards", "[rtl]") {
    int clean = 0;
    int wrong = 0;
    for (std::uint64_t seed = 300; seed < 340; ++seed) {
        CAPTURE(seed);
        Trial trial = random_trial(seed);
        trial.config.edge_map.algorithm = EdgeMapAlgorithm::dual_map;
        trial.config.rasterizer.edge_tokens = EdgeTokens::all;
        for (BramId const id : {BramId::edge_map, BramId::object_map})  // ports that let II be 1
            trial.config.memory(id).ports = 2;
        trial.config.loop(LoopId::token).ii = trial.config.loop(LoopId::token).recurrence_ii = 1;
        rtl::TwinSettings settings = settings_of(trial.config, trial.stimulus);
        settings.forwards = false;
        bool const differs = !difference(trial.config, settings, trial.stimulus).empty();
        bool const has_hazards = hazards_of(trial.config, trial.stimulus) > 0;
        CHECK((has_hazards || !differs));
        clean += has_hazards ? 0 : 1;
        wrong += differs ? 1 : 0;
    }
    CHECK(clean > 0);
    CHECK(wrong > 0);
}

TEST_CASE("The command says where model and twin differ first, and with which values", "[rtl]") {
    test::TempFolder const folder;
    auto const cosim = [&folder](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(),
                         {"cosim", source + "/traces/one_triangle", "--set", "accelerator.raster_cores=1"});
        return test::run_command(FASTER_SIM_BINARY, arguments, folder.path());
    };
    auto const same = cosim({});
    CHECK(same.exit_code == 0);
    CHECK(same.out.find("core 0: no difference in 5159 cycles: 3149 writes with their tokens, 3149 reads, 3 maps") ==
          0);
    auto const late = cosim({"--twin-set", "accelerator.fifos.vertex.write_latency=39"});
    CHECK(late.exit_code == 1);
    CHECK(late.out.find(
              "core 0, cycle 41: FIFO vertex: the twin writes (x 480, y 320, z 16384), the model does not\n") == 0);
    auto const stale = cosim({"--no-forwarding"});  // the trace has two hazards
    CHECK(stale.exit_code == 1);
    CHECK(stale.out.find("memory edge_map, row 13, column 14: the model has 0, the twin 1\n") != std::string::npos);
    auto const absent = cosim({"--core", "1"});
    CHECK(absent.exit_code == 2);
    CHECK(absent.err.find("--core 1: expected 0 to 0") != std::string::npos);
    auto const other = cosim({"--set", "accelerator.rasterizer.scan=early_exit"});
    CHECK(other.exit_code == 2);
    CHECK(other.err.find("accelerator.rasterizer.scan: expected zigzag") != std::string::npos);
    auto const half = cosim({"--set", "accelerator.rasterizer.scan=spans"});
    CHECK(half.exit_code == 2);
    CHECK(half.err.find("accelerator.edge_map.algorithm: expected inner_border") != std::string::npos);
    std::filesystem::copy(source + "/traces/one_triangle", folder / "far", std::filesystem::copy_options::recursive);
    auto const with_centre = [&folder](std::string const& col) {
        folder.write("far/samples.csv",
                     "sample,centre_row,centre_col,first_triangle,triangle_count\n0,24," + col + ",0,1\n");
        return test::run_command(FASTER_SIM_BINARY, {"cosim", "far", "--set", "accelerator.raster_cores=1"},
                                 folder.path());
    };
    CHECK(with_centre("28000").exit_code == 0);
    CHECK(with_centre("-27000").exit_code == 0);
    CHECK(with_centre("65560").exit_code == 2);
    CHECK(with_centre("65560").err.find("far/samples.csv: sample 0 has its centre at 65560 px, expected") !=
          std::string::npos);
}

TEST_CASE("Model and twin do the same in the same cycles: seeds 1 to 60", "[rtl]") { check_seeds(random_trial, 1, 60); }
TEST_CASE("Model and twin do the same in the same cycles: seeds 61 to 120", "[rtl]") {
    check_seeds(random_trial, 61, 60);
}

TEST_CASE("Designs with lanes do the same in the same cycles: seeds 1 to 100", "[rtl]") {
    check_seeds(random_lane_trial, 1, 100);
}

TEST_CASE("Areas that wait for a place wait in the same cycles", "[rtl]") {
    check_seeds(squeezed_trial, 201, 20);
    check_seeds(squeezed_lane_trial, 201, 20);
}

}  // namespace faster::testing::cosimulation_test
