#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/keys_as_markdown.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "faster/config/adopt_trace.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"

namespace config_test {

using faster::accelerator_of;
using faster::LoadedConfig;
using faster::RunConfig;
using faster::workload_of;
using faster::testing::BramId;
using faster::testing::FifoId;
using faster::testing::LoopId;
using faster::testing::ModuleId;
namespace fs = std::filesystem;

/// A folder of this process to write into. It is the current one while it exists, so that messages name "test.yaml".
class Scratch {
  public:
    Scratch()
        : before_(fs::current_path()),
          folder_(fs::temp_directory_path() / ("faster_config_test_" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "sub");
        fs::current_path(folder_);
    }
    ~Scratch() {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }
    Scratch(Scratch const&) = delete;
    Scratch& operator=(Scratch const&) = delete;

  private:
    fs::path before_;
    fs::path folder_;
};

void write(fs::path const& path, std::string const& content) { std::ofstream(path, std::ios::binary) << content; }

std::string read(fs::path const& path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

LoadedConfig loaded(std::string const& content, std::vector<std::string> const& overrides = {}) {
    Scratch const scratch;
    write("test.yaml", content);
    return faster::load_config("test.yaml", overrides);
}

template <class Action> std::string error_of(Action action) {
    try {
        action();
    } catch (faster::InputError const& error) {
        return error.what();
    }
    return "(no error)";
}

std::string file_error(std::string const& content) {
    return error_of([&] { loaded(content); });
}

std::string set_error(std::string const& setting) {
    return error_of([&] { loaded("", {setting}); });
}

bool all_default(RunConfig const& config) {
    for (auto const& entry : faster::resolved_keys(config)) {
        if (!entry.is_default) {
            return false;
        }
    }
    return true;
}

/// The current value of every key, as text.
std::string values_of(RunConfig const& config) {
    std::string values;
    for (auto const& entry : faster::resolved_keys(config)) {
        values += entry.key + '=' + faster::json_text(entry.value) + '\n';
    }
    return values;
}

std::string table_of_readme() {
    std::string const readme = read(fs::path(FASTER_SOURCE_DIR) / "configs" / "README.md");
    std::string const begin = "<!-- keys: begin -->\n";
    std::size_t const start = readme.find(begin) + begin.size();
    return readme.substr(start, readme.find("\n<!-- keys: end -->") - start);
}

TEST_CASE("An empty configuration is the default machine", "[config]") {
    std::string const content = GENERATE("", "\n# nothing\n", "{}\n", "---\n", "accelerator:\nworkload:\n  # scene:\n");
    LoadedConfig const config = loaded(content);
    CHECK(all_default(config.config));
    CHECK(config.origins.all().empty());
    CHECK(values_of(config.config) == values_of(RunConfig{}));
}

TEST_CASE("The defaults are those of the thesis and of docs/timing-model.md", "[config]") {
    RunConfig const config = loaded("").config;
    CHECK(accelerator_of(config).cores == 10);
    CHECK(accelerator_of(config).window == 200);
    CHECK(accelerator_of(config).clock_mhz == 200.0);
    CHECK(accelerator_of(config).fraction_bits == faster::FractionBits{4, 14, 30, 18, 9});
    faster::Machine const machine = faster::machine_of(config);
    CHECK(machine.fifos[index_of(FifoId::vertex)].write_latency == 40);
    CHECK(machine.fifos[index_of(FifoId::area_reciprocal)].write_latency == 36);
    CHECK(machine.loops[index_of(LoopId::fragment)].depth == 10);
    CHECK(workload_of(config).samples.count == 620);
}

TEST_CASE("Every kind of key can be set in a file", "[config]") {
    RunConfig const config = loaded(R"(
accelerator:
  raster_cores: 3
  clock_mhz: 2.5e2
  edge_map: {flush_last: true}
  fifos:
    area: {depth: 16, kind: memory}
    area_reciprocal: {write_latency: 50}
  loops:
    rasterizer: {setup: {depth: 20}, scan: {ii: 2, recurrence_ii: 3, depth: 9}}
  brams: {object_map: {ports: 4}}
workload:
  object: mug
  pose: {translation_m: [0.1, -0.2, 1], rotation_deg: [.5, 1e1, +3]}
  camera: {width: 320, cx: -1}
  scene:
    table: false
    objects:
      - {object: banana, translation_m: [1, 2, 3]}
      - object: "bowl"
        translation_m: [4, 5, 6]
        rotation_deg: [7, 8, 9]
  samples: {seed: 9223372036854775807}
simulation: {engine: lockstep}
)")
                                 .config;
    CHECK(accelerator_of(config).cores == 3);
    CHECK(accelerator_of(config).clock_mhz == 250.0);
    CHECK(accelerator_of(config).edge_map.flush_last);
    CHECK(accelerator_of(config).fifo(FifoId::area).depth == 16);
    CHECK(accelerator_of(config).fifo(FifoId::area).kind == faster::FifoKind::memory);
    CHECK(accelerator_of(config).fifo(FifoId::area_reciprocal).write_latency == 50);
    CHECK(accelerator_of(config).setup("rasterizer") == 20);
    CHECK(accelerator_of(config).loop(LoopId::scan).ii == 2);
    CHECK(accelerator_of(config).loop(LoopId::scan).recurrence_ii == 3);
    CHECK(accelerator_of(config).loop(LoopId::scan).depth == 9);
    CHECK(accelerator_of(config).memory(BramId::object_map).ports == 4);
    CHECK(workload_of(config).target.object == "mug");
    CHECK(workload_of(config).target.translation_m == std::array<double, 3>{0.1, -0.2, 1});
    CHECK(workload_of(config).target.rotation_deg == std::array<double, 3>{0.5, 10, 3});
    CHECK(workload_of(config).camera.width == 320);
    CHECK(workload_of(config).camera.cx == -1);
    CHECK_FALSE(workload_of(config).scene.table);
    REQUIRE(workload_of(config).scene.objects.size() == 2);
    CHECK(workload_of(config).scene.objects[0].object == "banana");
    CHECK(workload_of(config).scene.objects[0].rotation_deg == std::array<double, 3>{0, 0, 0});
    CHECK(workload_of(config).scene.objects[1].rotation_deg == std::array<double, 3>{7, 8, 9});
    CHECK(workload_of(config).samples.seed == 9223372036854775807U);
    CHECK(config.simulation.engine == faster::Engine::lockstep);
}

TEST_CASE("An override wins over the file, and a later one over an earlier", "[config]") {
    LoadedConfig const config = loaded("accelerator:\n  window: 100\n  raster_cores: 2\n",
                                       {"accelerator.window=64", "accelerator.window=32", "workload.object=bowl",
                                        "workload.pose.translation_m=[0, 0, 0.7]", "simulation.engine=lockstep",
                                        "workload.scene.objects=[{object: mug, translation_m: [0, 1, 2]}]"});
    CHECK(accelerator_of(config.config).window == 32);
    CHECK(accelerator_of(config.config).cores == 2);
    CHECK(workload_of(config.config).target.object == "bowl");
    CHECK(workload_of(config.config).target.translation_m[2] == 0.7);
    CHECK(config.config.simulation.engine == faster::Engine::lockstep);
    CHECK(workload_of(config.config).scene.objects.at(0).translation_m[2] == 2);
}

TEST_CASE("The loader remembers where a key was set", "[config]") {
    LoadedConfig const config = loaded("accelerator:\n  window: 100\n  raster_cores: 2\n", {"accelerator.window=64"});
    CHECK(config.origins.of("accelerator.window").place == "--set accelerator.window=64");
    CHECK(config.origins.of("accelerator.window").source == faster::KeySource::command_line);
    CHECK(config.origins.of("accelerator.raster_cores").place == "test.yaml:3");
    CHECK(config.origins.of("accelerator.raster_cores").source == faster::KeySource::file);
    CHECK_FALSE(config.origins.is_explicit("accelerator.clock_mhz"));
}

TEST_CASE("Paths of a file are relative to its folder, those of an override to the current one", "[config]") {
    Scratch const scratch;
    write("sub/test.yaml",
          "workload:\n  object: ../meshes/box.obj\n  trace: traces/a\n"
          "  scene: {depth_image: /data/1.png, objects: [{object: cup.ply, translation_m: [0, 0, 1]}]}\n");
    RunConfig const from_file = faster::load_config("sub/test.yaml").config;
    CHECK(workload_of(from_file).target.object == "meshes/box.obj");
    CHECK(workload_of(from_file).trace == "sub/traces/a");
    CHECK(workload_of(from_file).scene.depth_image == "/data/1.png");
    CHECK(workload_of(from_file).scene.objects.at(0).object == "sub/cup.ply");

    RunConfig const overridden =
        faster::load_config("sub/test.yaml", {"workload.object=box.obj", "workload.trace="}).config;
    CHECK(workload_of(overridden).target.object == "box.obj");
    CHECK(workload_of(overridden).trace.empty());
}

TEST_CASE("An unknown key names the nearest valid one", "[config][errors]") {
    CHECK(file_error("accelerator:\n  windwo: 3\n") ==
          "test.yaml:2: accelerator.windwo: unknown key, did you mean accelerator.window?");
    CHECK(file_error("acelerator:\n  window: 3\n") ==
          "test.yaml:1: acelerator: unknown key, did you mean accelerator?");
    CHECK(file_error("accelerator:\n  fifos:\n    comand: {depth: 2}\n") ==
          "test.yaml:3: accelerator.fifos.comand: unknown key, did you mean accelerator.fifos.command?");
    CHECK(file_error("raster_cores: 3\n") ==
          "test.yaml:1: raster_cores: unknown key, did you mean accelerator.raster_cores?");
    CHECK(file_error("accelerator:\n  cheese: 3\n") ==
          "test.yaml:2: accelerator.cheese: unknown key, expected in accelerator one of architecture, raster_cores, "
          "window, clock_mhz, fifo_rules, flow, fraction_bits, edge_map, rasterizer, inlier_unit, edge_extraction, "
          "memory, fifos, area_reciprocal, loops, "
          "brams, modules");
    CHECK(file_error("accelerator.window: 3\n") ==
          "test.yaml:1: accelerator.window: not a name, expected one map inside the other for a.b.c");
}

TEST_CASE("A partition needs a type, words for its banks, and no more banks than there can be", "[config][errors]") {
    CHECK(set_error("accelerator.brams.edge_map.partition.factor=4") ==
          "--set accelerator.brams.edge_map.partition.factor=4: expected 1, or "
          "accelerator.brams.edge_map.partition.type = \"none\" (default) to be cyclic or block");
    CHECK(set_error("accelerator.brams.object_map.partition.dimension=2") ==
          "--set accelerator.brams.object_map.partition.dimension=2: expected 0, or "
          "accelerator.brams.object_map.partition.type = \"none\" (default) to be cyclic or block");
    CHECK(
        file_error("accelerator:\n  window: 8\n  brams:\n    depth_buffer: {partition: {type: block, factor: 9}}\n") ==
        "test.yaml:4: accelerator.brams.depth_buffer.partition.factor = 9, expected at most accelerator.window = 8");
    CHECK(file_error("accelerator:\n  brams:\n    edge_map: {partition: {type: cyclic, factor: 33}}\n") ==
          "test.yaml:3: accelerator.brams.edge_map.partition.factor = 33, expected at most 1024 banks in all, with "
          "accelerator.brams.edge_map.partition.dimension = 0 (default)");
    CHECK(set_error("accelerator.brams.edge_map.partition.type=cyclc") ==
          "--set accelerator.brams.edge_map.partition.type=cyclc: expected one of none, cyclic, block, did you mean "
          "cyclic?");
    RunConfig const config =
        loaded("accelerator:\n  brams:\n    edge_map: {partition: {type: cyclic, factor: 32}}\n").config;
    CHECK(accelerator_of(config).memory(BramId::edge_map).partition.factor == 32);
}

TEST_CASE("Banks of a memory that is not square are bounded by its rows or its columns", "[config][errors]") {
    auto const error = [](std::string const& memory, std::string const& dimension) {
        return error_of([&] {
            loaded(
                "accelerator: {memory: {model: axi, mesh: on_chip, observation: on_chip, observation_width: 64,\n"
                "  observation_height: 3}}\n",
                {"accelerator.brams." + memory + ".partition.type=cyclic",
                 "accelerator.brams." + memory + ".partition.dimension=" + dimension,
                 "accelerator.brams." + memory + ".partition.factor=80"});
        });
    };
    std::string const factor = ".partition.factor=80: expected at most ";
    CHECK(error("observation", "1") ==
          "--set accelerator.brams.observation" + factor +
              "3, the rows of observation, with accelerator.brams.observation.partition.dimension = 1");
    CHECK(error("observation", "2") ==
          "--set accelerator.brams.observation" + factor +
              "64, the columns of observation, with accelerator.brams.observation.partition.dimension = 2");
    CHECK(error("mesh", "0") == "--set accelerator.brams.mesh" + factor +
                                    "1, the rows of mesh, with accelerator.brams.mesh.partition.dimension = 0");
}

TEST_CASE("A trace's window bounds the banks as well", "[config][errors]") {
    LoadedConfig config = loaded("accelerator:\n  brams:\n    edge_map: {partition: {type: cyclic, factor: 32}}\n");
    CHECK(error_of([&] { faster::adopt_trace(config, 64, 64, 16, {}, 1); }) ==
          "test.yaml:3: accelerator.brams.edge_map.partition.factor = 32, expected at most accelerator.window = 16");
}

TEST_CASE("There are no more lanes than columns", "[config][errors]") {
    CHECK(set_error("accelerator.inlier_unit.sweep_lanes=201") ==
          "--set accelerator.inlier_unit.sweep_lanes=201: expected at most accelerator.window = 200 (default)");
    CHECK(set_error("accelerator.inlier_unit.sweep_lanes=0") ==
          "--set accelerator.inlier_unit.sweep_lanes=0: expected an integer from 1 to 4096");
}

TEST_CASE("The scan has lanes where only covered pixels are told of", "[config][errors]") {
    CHECK(
        set_error("accelerator.rasterizer.lanes=4") ==
        "--set accelerator.rasterizer.lanes=4: expected 1, or accelerator.edge_map.algorithm = \"dual_map\" (default) "
        "to be inner_border and accelerator.rasterizer.edge_tokens = \"all\" (default) to be object");
    CHECK(set_error("accelerator.rasterizer.lanes=33") ==
          "--set accelerator.rasterizer.lanes=33: expected an integer from 1 to 32");
    CHECK(file_error("accelerator: {window: 16, edge_map: {algorithm: inner_border},\n"
                     "  rasterizer: {edge_tokens: object,\n"
                     "    lanes: 17}}\n") ==
          "test.yaml:3: accelerator.rasterizer.lanes = 17, expected at most accelerator.window = 16");
    CHECK(file_error("accelerator: {edge_map: {algorithm: inner_border}, rasterizer: {lanes: 2}}\n")
              .find("to be object") != std::string::npos);
    CHECK(file_error(
              "accelerator: {edge_map: {algorithm: inner_border}, rasterizer: {edge_tokens: object, lanes: 2}}\n") ==
          "(no error)");
    CHECK(file_error("accelerator: {flow: fpga_grip, rasterizer: {lanes: 2}}\n") == "(no error)");
}

TEST_CASE("An override of an unknown key names the nearest valid one", "[config][errors]") {
    CHECK(set_error("accelerator.fifo.command.depth=4") ==
          "--set accelerator.fifo.command.depth=4: unknown key, did you mean accelerator.fifos.command.depth?");
    CHECK(set_error("accelerator.loops.rasterizer.setup.ii=4") ==
          "--set accelerator.loops.rasterizer.setup.ii=4: unknown key, expected in accelerator.loops.rasterizer.setup "
          "one of depth");
    CHECK(set_error("accelerator.fifos.area.write_latency=4") ==
          "--set accelerator.fifos.area.write_latency=4: unknown key, expected in accelerator.fifos.area one of depth, "
          "kind");
    CHECK(set_error("accelerator.window.size=4") ==
          "--set accelerator.window.size=4: unknown key, accelerator.window has one value and nothing below it");
    CHECK(
        set_error("accelerator.fifos.vertex=4") ==
        "--set accelerator.fifos.vertex=4: accelerator.fifos.vertex is a section, expected a key in it, one of depth, "
        "kind, write_latency");
}

TEST_CASE("An override is a key, an equals sign and a value", "[config][errors]") {
    CHECK(set_error("accelerator.window") == "--set accelerator.window: expected KEY=VALUE");
    CHECK(set_error("=3") == "--set =3: expected KEY=VALUE");
    CHECK(set_error("") == "--set : expected KEY=VALUE");
    CHECK(set_error("workload.object=\xFF") == "--set workload.object=\\xff: expected printable UTF-8 text");
}

TEST_CASE("A key that stands twice in one map is an error", "[config][errors]") {
    CHECK(file_error("accelerator:\n  window: 3\n  raster_cores: 1\n  window: 4\n") ==
          "test.yaml:4: accelerator.window: stands twice, expected once (first in line 2)");
    CHECK(file_error("accelerator: {window: 3}\naccelerator: {raster_cores: 3}\n") ==
          "test.yaml:2: accelerator: stands twice, expected once (first in line 1)");
    CHECK(file_error("[1, 2]: 3\n") == "test.yaml:1: a list of 2: not a name, expected a key");
}

TEST_CASE("An integer is a plain decimal number", "[config][errors]") {
    std::string const value = GENERATE("2.0", "0x2", "0o2", "010", "yes", "true", "2e1", "1_000", "+2", "\"2\"", ".inf",
                                       "99999999999999999999", "-1", "0", "4097");
    CHECK(file_error("accelerator:\n  window: " + value + "\n") ==
          "test.yaml:2: accelerator.window = " + value + ", expected an integer from 1 to 4096");
    CHECK(set_error("accelerator.window=" + value) ==
          "--set accelerator.window=" + value + ": expected an integer from 1 to 4096");
}

TEST_CASE("An integer of more than 63 bits is told how large it may be", "[config][errors]") {
    CHECK(set_error("workload.samples.seed=9223372036854775808") ==
          "--set workload.samples.seed=9223372036854775808: expected an integer, 0 or more, up to 9223372036854775807");
    CHECK(set_error("workload.samples.seed=-1") == "--set workload.samples.seed=-1: expected an integer, 0 or more");
}

TEST_CASE("No value and a null are wrong wherever a value is expected", "[config][errors]") {
    std::string const value = GENERATE("", "~", "null");
    CHECK(file_error("accelerator:\n  window: " + value + "\n") ==
          "test.yaml:2: accelerator.window = nothing, expected an integer from 1 to 4096");
    CHECK(file_error("workload: {trace: " + value + "}\n") == "test.yaml:1: workload.trace = nothing, expected a path");
    CHECK(set_error("accelerator.window=" + value) ==
          "--set accelerator.window=" + value + ": expected an integer from 1 to 4096");
    CHECK(set_error("workload.pose.rotation_deg=" + value) ==
          "--set workload.pose.rotation_deg=" + value + ": expected a list of 3 numbers");
}

TEST_CASE("A boolean is true or false and nothing else", "[config][errors]") {
    std::string const value = GENERATE("yes", "on", "True", "FALSE", "1", "\"true\"");
    CHECK(file_error("workload:\n  scene:\n    table: " + value + "\n") ==
          "test.yaml:3: workload.scene.table = " + value + ", expected true or false");
    CHECK(set_error("workload.scene.table=" + value) ==
          "--set workload.scene.table=" + value + ": expected true or false");
}

TEST_CASE("A number is finite and decimal", "[config][errors]") {
    std::string const value = GENERATE("fast", ".inf", ".nan", "0x10", "1e999", "+-5", "0", "-2", "\"200\"");
    CHECK(file_error("accelerator:\n  clock_mhz: " + value + "\n") ==
          "test.yaml:2: accelerator.clock_mhz = " + value + ", expected a number from 0.001 to 1000000");
}

TEST_CASE("Text is not a number, a boolean or a list", "[config][errors]") {
    CHECK(file_error("workload: {object: 7}\n") ==
          "test.yaml:1: workload.object = 7, expected an object class or the path of a mesh file");
    CHECK(file_error("workload: {object: \"\"}\n") ==
          "test.yaml:1: workload.object = \"\", expected an object class or the path of a mesh file");
    CHECK(file_error("workload: {trace: [a, b]}\n") == "test.yaml:1: workload.trace = a list of 2, expected a path");
    CHECK(file_error("simulation: {engine: fast}\n") ==
          "test.yaml:1: simulation.engine = fast, expected one of lockstep, decoupled");
    CHECK(set_error("accelerator.fifos.area.kind=fifo") ==
          "--set accelerator.fifos.area.kind=fifo: expected one of auto, shift_register, memory");
    CHECK(file_error("workload: {trace: !!str 7}\n") ==
          "test.yaml:1: workload.trace = tag:yaml.org,2002:str 7, expected a path");
}

TEST_CASE("A list of the wrong length or with a wrong element is an error", "[config][errors]") {
    CHECK(file_error("workload:\n  pose:\n    translation_m: [1, 2]\n") ==
          "test.yaml:3: workload.pose.translation_m = a list of 2, expected a list of 3 numbers");
    CHECK(file_error("workload:\n  pose:\n    translation_m: 3\n") ==
          "test.yaml:3: workload.pose.translation_m = 3, expected a list of 3 numbers");
    CHECK(file_error("workload:\n  pose:\n    translation_m:\n      - 1\n      - x\n      - 2\n") ==
          "test.yaml:5: workload.pose.translation_m[1] = x, expected a number");
    CHECK(set_error("workload.pose.translation_m=[1, x, 2]") ==
          "--set workload.pose.translation_m=[1, x, 2]: workload.pose.translation_m[1] = x, expected a number");
    CHECK(set_error("workload.pose.translation_m=[1, 2, 3], 4") ==
          "--set workload.pose.translation_m=[1, 2, 3], 4: expected a list of 3 numbers (a second document)");
    CHECK(set_error("workload.pose.translation_m=[1, 2") ==
          "--set workload.pose.translation_m=[1, 2: expected a list of 3 numbers (end of sequence flow not found)");
}

TEST_CASE("An object of the scene has a class, a place and nothing unknown", "[config][errors]") {
    CHECK(file_error("workload:\n  scene:\n    objects:\n      - mug\n") ==
          "test.yaml:4: workload.scene.objects[0] = mug, expected a map");
    CHECK(file_error("workload:\n  scene:\n    objects:\n      - {object: mug}\n") ==
          "test.yaml:4: workload.scene.objects[0]: no key translation_m, expected one");
    CHECK(file_error("workload:\n  scene:\n    objects:\n"
                     "      - object: mug\n        translation_m: [0, 0, 1]\n        colour: red\n") ==
          "test.yaml:6: workload.scene.objects[0].colour: unknown key, expected one of object, translation_m, "
          "rotation_deg");
    CHECK(file_error("workload:\n  scene:\n    objects:\n"
                     "      - object: mug\n        translation_m: [0, 0]\n        object: cup\n") ==
          "test.yaml:6: workload.scene.objects[0].object: stands twice, expected once (first in line 4) (and 1 more)");
    CHECK(file_error("workload: {scene: {objects: {object: mug}}}\n") ==
          "test.yaml:1: workload.scene.objects = a map, expected a list of maps");
}

TEST_CASE("A section is a map and a key is not", "[config][errors]") {
    CHECK(file_error("accelerator:\n  edge_map: true\n") ==
          "test.yaml:2: accelerator.edge_map = true, expected a map with algorithm, flush_last, clearing, "
          "buffers, threshold_w0, threshold_w1, threshold_w2");
    CHECK(file_error("accelerator:\n  window: {size: 3}\n") ==
          "test.yaml:2: accelerator.window = a map, expected an integer from 1 to 4096");
    CHECK(file_error("- accelerator\n") ==
          "test.yaml:1: the file is a list, expected a map with accelerator, workload, estimator, host, simulation");
    CHECK(
        file_error("accelerator\n") ==
        "test.yaml:1: the file is accelerator, expected a map with accelerator, workload, estimator, host, simulation");
}

TEST_CASE("A file that is no YAML text is an error", "[config][errors]") {
    CHECK(file_error("accelerator:\n  window: [1, 2\n") ==
          "test.yaml:3: end of sequence flow not found, expected well-formed YAML, one document");
    CHECK(file_error("accelerator:\n  window: \"\xC3(\"\n") == "test.yaml:2: byte 0xC3, expected printable UTF-8 text");
    CHECK(file_error(std::string("accelerator:\0", 13)) == "test.yaml:1: byte 0x00, expected printable UTF-8 text");
    CHECK(file_error("accelerator:\n---\nworkload:\n") ==
          "test.yaml:2: a second document, expected well-formed YAML, one document");
    CHECK(file_error("accelerator: {window: 3}\n...\n") == "(no error)");
    CHECK(file_error(", 620 samples\n") == "test.yaml:1: a second document, expected well-formed YAML, one document");
}

TEST_CASE("A missing file and a folder are errors", "[config][errors]") {
    Scratch const scratch;
    CHECK(error_of([] { faster::load_config("none.yaml"); }) ==
          "none.yaml: no such file, expected a configuration file");
    CHECK(error_of([] { faster::load_config("sub"); }) == "sub: is a folder, expected a configuration file");
}

TEST_CASE("Another file of ours is told by name, with the command that reads it", "[config][errors]") {
    CHECK_THAT(file_error("# a sweep\nformat: faster-sweep\nversion: 1\n"),
               Catch::Matches("test\\.yaml:2: the file is a sweep file \\(.* sweep reads it\\), "
                              "expected a configuration file"));
    CHECK_THAT(file_error(R"({"format": "faster-summary", "version": 1})"), Catch::Contains(" compare reads it"));
    CHECK(file_error("format: faster-trace\n") ==
          "test.yaml:1: the file is of format faster-trace, expected a configuration file");
    CHECK_THAT(file_error(std::string("FASTEREV\x05\0\0\0", 12)),
               Catch::StartsWith("test.yaml: the file is an event file ("));
    CHECK_THAT(file_error("format: 3\n"), Catch::Contains("format: unknown key"));
}

TEST_CASE("Several faults are one line: the first, and how many more", "[config][errors]") {
    CHECK(file_error("accelerator:\n  window: 0\n  raster_cores: 0\nworkload: 3\n") ==
          "test.yaml:2: accelerator.window = 0, expected an integer from 1 to 4096 (and 2 more)");
    CHECK(error_of([] { loaded("accelerator: {window: 0}", {"nothing"}); }) ==
          "test.yaml:1: accelerator.window = 0, expected an integer from 1 to 4096 (and 1 more)");
    CHECK(file_error("accelerator:\n  window: \"a\\nb\"\n") ==
          "test.yaml:2: accelerator.window = \"a\\nb\", expected an integer from 1 to 4096");
}

TEST_CASE("Every integer key takes both ends of its range and nothing beyond", "[config]") {
    for (faster::Key const& key : faster::all_keys()) {
        if (key.kind != faster::KeyKind::integer) {
            continue;
        }
        RunConfig config;
        for (auto const end : {key.integers.min, key.integers.max}) {
            key.write(config, end);
            INFO(key.name());
            CHECK(faster::json_text(key.read(config)) == std::to_string(end));
        }
        CHECK(set_error(key.name() + '=' + std::to_string(key.integers.min - 1)) ==
              "--set " + key.name() + '=' + std::to_string(key.integers.min - 1) + ": expected " +
                  faster::expectation(key));
    }
}

TEST_CASE("A write latency stays below the depth of the loop that writes", "[config][errors]") {
    CHECK(set_error("accelerator.fifos.edge_map.write_latency=3") ==
          "--set accelerator.fifos.edge_map.write_latency=3: expected at most 2, one less than "
          "accelerator.loops.edge_map_builder.output.depth = 3 (default)");
    CHECK(file_error("accelerator:\n  fifos:\n    vertex:\n      write_latency: 41\n") ==
          "test.yaml:4: accelerator.fifos.vertex.write_latency = 41, expected at most 40, one less than "
          "accelerator.loops.vertex_transform.vertex.depth = 41 (default)");
    CHECK(set_error("accelerator.fifos.area_reciprocal.write_latency=1000000") == "(no error)");
}

TEST_CASE("A loop that gets too short for a default write latency asks to set that too", "[config][errors]") {
    CHECK(file_error("accelerator:\n  loops:\n    edge_map_builder:\n      output:\n        depth: 2\n") ==
          "test.yaml:5: accelerator.loops.edge_map_builder.output.depth = 2, expected at least 3 because of "
          "accelerator.fifos.edge_map.write_latency = 2 (default): set that too, to at most 1");
    CHECK(set_error("accelerator.loops.rasterizer.scan.depth=7") ==
          "--set accelerator.loops.rasterizer.scan.depth=7: expected at least 8 because of "
          "accelerator.fifos.command.write_latency = 7 (default): set that too, to at most 6 (and 3 more)");
    CHECK(error_of([] {
              loaded("", {"accelerator.loops.edge_map_builder.output.depth=2",
                          "accelerator.fifos.edge_map.write_latency=1"});
          }) == "(no error)");
}

TEST_CASE("A FIFO that the flow does not have asks no loop to be longer", "[config][errors]") {
    CHECK(error_of([] {
              loaded("",
                     {"accelerator.flow=fpga_grip", "accelerator.loops.rasterizer.scan.depth=6",
                      "accelerator.fifos.command.write_latency=5", "accelerator.fifos.fragment_depth.write_latency=5",
                      "accelerator.fifos.fragment_index.write_latency=5"});
          }) == "(no error)");
}

TEST_CASE("Every FIFO that a loop writes is checked against that loop", "[config][errors]") {
    std::map<std::string, LoopId> const written_by{{"vertex", LoopId::vertex},       {"command", LoopId::scan},
                                                   {"fragment_depth", LoopId::scan}, {"fragment_index", LoopId::scan},
                                                   {"edge_token", LoopId::scan},     {"edge_map", LoopId::output},
                                                   {"observed_depth", LoopId::read}, {"observed_edge", LoopId::read}};
    faster::Machine const defaults = faster::machine_of(RunConfig{});
    for (FifoId const id : faster::testing::fifo_ids) {
        std::string const key = faster::fifo_key_name(id, "write_latency");
        INFO(key);
        auto const written = written_by.find(id);
        bool const has_latency = written != written_by.end() || id == FifoId::area_reciprocal;
        CHECK((faster::find_key(key) != nullptr) == has_latency);
        if (written == written_by.end()) {
            continue;
        }
        auto const depth = defaults.loops[index_of(written->second)].depth;
        CHECK(set_error(key + '=' + std::to_string(depth - 1)) == "(no error)");
        CHECK(set_error(key + '=' + std::to_string(depth)) != "(no error)");
    }
}

TEST_CASE("The reciprocal and the area fit 62 bits together", "[config][errors]") {
    CHECK(set_error("accelerator.fraction_bits.area_reciprocal=54") == "(no error)");
    CHECK(set_error("accelerator.fraction_bits.area_reciprocal=55") ==
          "--set accelerator.fraction_bits.area_reciprocal=55: expected at most 54, which is 62 minus twice "
          "accelerator.fraction_bits.vertex_xy = 4 (default)");
    CHECK(error_of([] { loaded("accelerator: {fraction_bits: {vertex_xy: 15, area_reciprocal: 33}}"); }) ==
          "test.yaml:1: accelerator.fraction_bits.area_reciprocal = 33, expected at most 32, which is 62 minus twice "
          "accelerator.fraction_bits.vertex_xy = 15");
}

TEST_CASE("The edge tokens of threshold lie where only the zigzag looks", "[config][errors]") {
    char const* const threshold = "accelerator: {edge_map: {algorithm: threshold}, rasterizer: {scan: ";
    CHECK(error_of([&] { loaded(threshold + std::string("spans}}")); }) ==
          "test.yaml:1: accelerator.rasterizer.scan = \"spans\", expected zigzag because of "
          "accelerator.edge_map.algorithm = \"threshold\", whose edge tokens lie outside the triangles too");
    CHECK(error_of([&] { loaded(threshold + std::string("early_exit}}")); }) != "(no error)");
    CHECK(error_of([&] { loaded(threshold + std::string("zigzag, setup_overlap: 3}}")); }) == "(no error)");
}

TEST_CASE("The neighbourhood of an observed edge has a middle", "[config][errors]") {
    CHECK(set_error("workload.observed_edges.neighbourhood=4") ==
          "--set workload.observed_edges.neighbourhood=4: expected an odd number");
}

TEST_CASE("A key of a part that the flow does not have is refused, unless it says the default", "[config][errors]") {
    CHECK(set_error("accelerator.edge_extraction.threshold=0.02") ==
          "--set accelerator.edge_extraction.threshold=0.02: expected a key of the parts that accelerator.flow = "
          "\"faster\" (default) has");
    CHECK(set_error("accelerator.edge_extraction.threshold=0.01") == "(no error)");
    std::vector<std::string> const settings{"accelerator.flow=fpga_grip",
                                            "accelerator.edge_extraction.neighbourhood=7"};
    RunConfig const config = loaded("", settings).config;
    CHECK(accelerator_of(config).edge_extraction.neighbourhood == 7);
    CHECK(values_of(loaded(faster::to_yaml(config)).config) == values_of(config));
    CHECK(error_of([] { loaded("accelerator: {flow: fpga_grip, fifos: {edge_map: {depth: 4}}}"); }) ==
          "test.yaml:1: accelerator.fifos.edge_map.depth = 4, expected a key of the parts that accelerator.flow = "
          "\"fpga_grip\" has");
}

TEST_CASE("FIFOs of the touched region have keys where it is swept", "[config][errors][sweep_region]") {
    CHECK(
        set_error("accelerator.fifos.region.depth=4") ==
        "--set accelerator.fifos.region.depth=4: expected a key of the parts that accelerator.inlier_unit.sweep_region "
        "= \"window\" (default) has");
    CHECK(error_of([] {
              loaded("accelerator: {inlier_unit: {sweep_region: touched}, fifos: {valid_depth: {depth: 4}}}");
          }) == "(no error)");
    CHECK(set_error("accelerator.inlier_unit.sweep_region=touch") != "(no error)");
    char const* const touched = "accelerator: {inlier_unit: {sweep_region: touched}, fraction_bits: {depth_buffer: ";
    CHECK(error_of([&] { loaded(touched + std::string("9}}")); }) == "(no error)");
    CHECK(error_of([&] { loaded(touched + std::string("10}}")); }) ==
          "test.yaml:1: accelerator.inlier_unit.sweep_region = \"touched\", expected window because of "
          "accelerator.fraction_bits.depth_buffer = 10, with which pixels that nothing touched are nearer than 2 m");
}

TEST_CASE("A touched region goes with one buffer and with two, and each brings its FIFOs", "[config]") {
    for (std::string const maps : {"1", "2"})
        for (std::string const depths : {"1", "2"}) {
            CAPTURE(maps, depths);
            RunConfig const config =
                loaded("", {"accelerator.inlier_unit.sweep_region=touched", "accelerator.edge_map.buffers=" + maps,
                            "accelerator.inlier_unit.buffers=" + depths, "accelerator.fifos.region.depth=3"})
                    .config;
            faster::Machine const machine = faster::machine_of(config);
            CHECK(machine.fifos[index_of(FifoId::region)].is_present);
            CHECK(machine.fifos[index_of(FifoId::map_full)].is_present == (maps == "2"));
            CHECK(machine.fifos[index_of(FifoId::depth_full)].is_present == (depths == "2"));
            CHECK(values_of(loaded(faster::to_yaml(config)).config) == values_of(config));
        }
}

TEST_CASE("Each flow has timing keys of its own parts only", "[config]") {
    auto const has = [](faster::Flow flow, std::string const& name) {
        RunConfig config;
        accelerator_of(config).flow = flow;
        auto const keys = faster::timing_keys(config);
        return std::any_of(keys.begin(), keys.end(), [&](faster::Key const& key) { return key.name() == name; });
    };
    for (std::string const name :
         {"accelerator.fifos.edge_token.depth", "accelerator.loops.edge_map_builder.token.ii"}) {
        CHECK(has(faster::Flow::faster, name));
        CHECK_FALSE(has(faster::Flow::fpga_grip, name));
    }
    for (std::string const name :
         {"accelerator.loops.inlier_unit.extract.ii", "accelerator.edge_extraction.square_root_latency"}) {
        CHECK_FALSE(has(faster::Flow::faster, name));
        CHECK(has(faster::Flow::fpga_grip, name));
    }
}

TEST_CASE("Keys of FIFOs between two buffers are refused where there is one", "[config][errors]") {
    CHECK(set_error("accelerator.fifos.map_full.depth=3") ==
          "--set accelerator.fifos.map_full.depth=3: expected a key of the parts that accelerator.edge_map.buffers = 1 "
          "(default) has");
    CHECK(set_error("accelerator.fifos.depth_free.kind=memory") ==
          "--set accelerator.fifos.depth_free.kind=memory: expected a key of the parts that "
          "accelerator.inlier_unit.buffers = 1 (default) has");
    CHECK(error_of([] {
              loaded("", {"accelerator.edge_map.buffers=2", "accelerator.fifos.map_full.depth=3"});
          }) == "(no error)");
    CHECK(error_of([] {
              loaded("", {"accelerator.flow=fpga_grip", "accelerator.fifos.map_full.depth=3"});
          }) ==
          "--set accelerator.fifos.map_full.depth=3: expected a key of the parts that accelerator.flow = "
          "\"fpga_grip\" has");
    CHECK(set_error("accelerator.inlier_unit.buffers=3") != "(no error)");
    CHECK(error_of([] {
              loaded("", {"accelerator.flow=fpga_grip", "accelerator.edge_map.buffers=2"});
          }) != "(no error)");
}

TEST_CASE("Loops keep their keys when buffers move them to another process", "[config]") {
    std::vector<std::string> const settings{"accelerator.edge_map.buffers=2", "accelerator.inlier_unit.buffers=2",
                                            "accelerator.loops.edge_map_builder.output.depth=5",
                                            "accelerator.loops.inlier_unit.sweep.ii=2"};
    RunConfig const config = loaded("", settings).config;
    faster::Machine const machine = faster::machine_of(config);
    faster::MachineLoop const& sweep = machine.loops[index_of(LoopId::buffered_sweep)];
    CHECK(machine.loops[index_of(LoopId::buffered_output)].depth == 5);
    CHECK(sweep.interval.target == 2);
    CHECK(faster::loop_key_name(sweep.timed_by, "ii") == "accelerator.loops.inlier_unit.sweep.ii");
    faster::IdleKeys const idle = faster::idle_keys(config);
    CHECK(idle.decider_of("accelerator.loops.inlier_unit.sweep.ii") == nullptr);
    CHECK(idle.decider_of("accelerator.loops.inlier_unit.extract.ii") != nullptr);
    CHECK_FALSE(machine.loops[index_of(LoopId::sweep)].is_present);
    CHECK(sweep.is_present);
}

TEST_CASE("Two buffers put other modules at the ends of FIFOs", "[config]") {
    RunConfig config;
    auto const machine = [&config] { return faster::machine_of(config); };
    auto const writer = [&](FifoId id) { return faster::testing::module_ids[machine().fifos[index_of(id)].writer]; };
    auto const reader = [&](FifoId id) { return faster::testing::module_ids[machine().fifos[index_of(id)].reader]; };
    CHECK(machine().process_places() == 8);
    CHECK(writer(FifoId::edge_map) == ModuleId::edge_map_builder);
    CHECK(reader(FifoId::edge_map) == ModuleId::inlier_unit);
    accelerator_of(config).edge_map.buffers = 2;
    CHECK(writer(FifoId::edge_map) == ModuleId::edge_map_output);
    CHECK(reader(FifoId::edge_map) == ModuleId::inlier_unit);
    accelerator_of(config).inlier_unit.buffers = 2;
    for (FifoId const fifo : {FifoId::edge_map, FifoId::observed_depth, FifoId::observed_edge}) {
        CHECK(reader(fifo) == ModuleId::inlier_sweep);
    }
    CHECK(writer(FifoId::result) == ModuleId::inlier_sweep);
    CHECK(reader(FifoId::command) == ModuleId::inlier_unit);
    CHECK(machine().process_places() == faster::testing::module_count);
}

TEST_CASE("A trace replaces what the file says", "[config][trace]") {
    LoadedConfig config = loaded("accelerator: {window: 100}\nworkload: {camera: {width: 100}}\n");
    faster::adopt_trace(config, 320, 240, 64, {3, 12, 20, 16, 8}, 7);
    CHECK(accelerator_of(config.config).window == 64);
    CHECK(accelerator_of(config.config).fraction_bits == faster::FractionBits{3, 12, 20, 16, 8});
    CHECK(workload_of(config.config).camera.width == 320);
    CHECK(workload_of(config.config).camera.height == 240);
    CHECK(workload_of(config.config).samples.count == 7);
    CHECK(config.origins.of("accelerator.window").source == faster::KeySource::trace);
}

TEST_CASE("What a trace replaces cannot be asked for beside it", "[config][trace][errors]") {
    LoadedConfig config = loaded("workload: {object: mug}\n", {"workload.trace=t", "workload.samples.seed=2"});
    CHECK(error_of([&] { faster::adopt_trace(config, 320, 240, 64, {}, 1); }) ==
          "--set workload.samples.seed=2: expected none with workload.trace = \"t\", which replaces it");
}

TEST_CASE("The command line names one trace", "[config][trace][errors]") {
    CHECK(faster::setting_of_trace("a", {"accelerator.window=64"}) == "workload.trace=a");
    CHECK(faster::setting_of_trace("a/b", {"workload.trace=./a/c/../b"}) == "workload.trace=a/b");
    CHECK(error_of([] { faster::setting_of_trace("a", {"workload.trace=b"}); }) ==
          "--set workload.trace=b: expected none with the trace a, which replaces it");
}

TEST_CASE("A trace and an override that say the same agree", "[config][trace]") {
    LoadedConfig config = loaded("", {"accelerator.window=64", "workload.camera.width=320"});
    CHECK_NOTHROW(faster::adopt_trace(config, 320, 240, 64, {}, 1));
}

TEST_CASE("A trace that contradicts an override is an error and changes nothing", "[config][trace][errors]") {
    LoadedConfig config = loaded("", {"accelerator.window=64", "accelerator.fraction_bits.depth_buffer=8"});
    std::string const before = values_of(config.config);
    CHECK(error_of([&] { faster::adopt_trace(config, 320, 240, 200, {}, 1); }) ==
          "--set accelerator.window=64: expected 200, as in the trace (and 1 more)");
    CHECK(values_of(config.config) == before);
}

TEST_CASE("The resolved configuration loads to the same values", "[config]") {
    std::vector<std::string> const settings{
        "accelerator.clock_mhz=199.99999999999997", "accelerator.fifos.area.kind=memory",
        "workload.trace=a \"folder\" # with \\", "workload.pose.rotation_deg=[0.1, -1e-7, 1e300]",
        "workload.scene.objects=[{object: a b.obj, translation_m: [1, 2, 3]}]"};
    RunConfig const config = loaded("", settings).config;
    RunConfig const again = loaded(faster::to_yaml(config)).config;
    CHECK(values_of(again) == values_of(config));
    CHECK(workload_of(again).trace == "a \"folder\" # with \\");
    CHECK(values_of(loaded(faster::to_yaml(RunConfig{})).config) == values_of(RunConfig{}));
}

TEST_CASE("The resolved configuration marks what differs from the defaults", "[config]") {
    RunConfig const config = loaded("accelerator: {window: 100, raster_cores: 10}").config;
    for (auto const& entry : faster::resolved_keys(config)) {
        INFO(entry.key);
        CHECK(entry.is_default == (entry.key != "accelerator.window"));
    }
    CHECK(faster::to_yaml(config).find("  window: 100  # default 200\n") != std::string::npos);
}

TEST_CASE("Every key is documented, once, and its default is legal", "[config]") {
    for (faster::Key const& key : faster::all_keys()) {
        INFO(key.name());
        CHECK(faster::find_key(key.name()) == &key);
        CHECK(!key.text.meaning.empty());
        CHECK(key.text.meaning.back() == '.');
        CHECK(!key.text.source.empty());
        CHECK(!faster::is_section(key.name()));
    }
    CHECK(set_error("accelerator.window=200") == "(no error)");
}

TEST_CASE("The README of the configurations documents exactly the keys there are", "[config][documentation]") {
    CHECK(table_of_readme() == faster::keys_as_markdown());
}

TEST_CASE("The configurations of this project load", "[config]") {
    std::size_t files = 0;
    for (auto const& entry : fs::directory_iterator(fs::path(FASTER_SOURCE_DIR) / "configs")) {
        if (entry.path().extension() == ".yaml") {
            ++files;
            INFO(entry.path());
            CHECK(error_of([&] { faster::load_config(entry.path()); }) == "(no error)");
        }
    }
    CHECK(files >= 6);
}

TEST_CASE("A map takes the entries of those that << names, its own first", "[config][yaml]") {
    std::string const base =
        "x-base: &base {raster_cores: 3, window: 60}\nx-other: &other {window: 70, clock_mhz: 150}\n";
    LoadedConfig config = loaded(base + "accelerator:\n  <<: *base\n");
    CHECK(accelerator_of(config.config).cores == 3);
    CHECK(accelerator_of(config.config).window == 60);
    config = loaded(base + "accelerator:\n  <<: *base\n  raster_cores: 5\n");
    CHECK(accelerator_of(config.config).cores == 5);
    config = loaded(base + "accelerator:\n  raster_cores: 5\n  <<: [*other, *base]\n");
    CHECK(accelerator_of(config.config).cores == 5);
    CHECK(accelerator_of(config.config).window == 70);
    CHECK(accelerator_of(config.config).clock_mhz == 150);
    config = loaded("accelerator: {<<: {<<: {window: 40, raster_cores: 2}, window: 50}}\n");
    CHECK(accelerator_of(config.config).window == 50);
    CHECK(accelerator_of(config.config).cores == 2);
    config = loaded("x-a: &a {window: 50}\nx-b: &b {<<: *a, raster_cores: 2}\naccelerator: {<<: *b}\n");
    CHECK(accelerator_of(config.config).window == 50);
    config = loaded("<<: {accelerator: {window: 50}}\n");
    CHECK(accelerator_of(config.config).window == 50);
}

TEST_CASE("<< takes maps and lists of maps, and faults in them are where they stand", "[config][yaml][errors]") {
    CHECK(file_error("accelerator:\n  <<: 3\n").find("test.yaml:2: << with something else than a map") == 0);
    CHECK(file_error("a: &a {window: 8, window: 9}\naccelerator:\n  <<: *a\n").find("stands twice, expected once") !=
          std::string::npos);
    CHECK(
        file_error("a: &a {window: 8}\naccelerator:\n  <<: *a\n  <<: *a\n").find("test.yaml:4: a second << in a map") ==
        0);
    CHECK(file_error("accelerator:\n  <<: [{window: 3}, 4]\n").find("test.yaml:2: << with something else") == 0);
    CHECK(file_error("x-a: &a\n  window: x\naccelerator:\n  <<: *a\n").find("test.yaml:2: accelerator.window = x,") ==
          0);
    CHECK(file_error("accelerator: {\"<<\": {window: 3}}\n").find("unknown key") != std::string::npos);
    CHECK(file_error("x-a: &a x\naccelerator:\n  window: *a\n") ==
          "test.yaml:3: accelerator.window = x (in line 1), expected an integer from 1 to 4096");
}

TEST_CASE("A key at the top may hold something for aliases alone", "[config][yaml]") {
    for (std::string const holder : {"x: &m\n  max_triangles: 100\n", "x-m: {max_triangles: 100}\n", ".m: [3]\n",
                                     "sizes: &m 3\n", "nothing: &m\n", "list: &m [1, 2]\n"}) {
        CAPTURE(holder);
        CHECK(file_error(holder + "accelerator: {raster_cores: 2}\n") == "(no error)");
    }
    CHECK(file_error("x: {max_triangles: 100}\n").find("test.yaml:1: x: unknown key") == 0);
    CHECK(file_error("acelerator: &a {raster_cores: 2}\n").find("did you mean accelerator") != std::string::npos);
    CHECK(file_error("accelerator: {x-m: &m 3}\n").find("test.yaml:1: accelerator.x-m: unknown key") == 0);
    CHECK(file_error("accelerator: {raster_cores: &cores 2, window: *cores}\n") == "(no error)");
}

TEST_CASE("What cannot be seen in a value can be seen in the message", "[config][errors]") {
    CHECK(file_error("accelerator: {raster_cores: 2\xC2\xA0}\n").find("= 2\\u00a0, expected") != std::string::npos);
    CHECK(file_error("accelerator: {\xEF\xBB\xBFwindow: 2}\n").find("accelerator.\\ufeffwindow: unknown key") !=
          std::string::npos);
    CHECK(file_error("accelerator: {window: \"6\\e[0m\"}\n").find("= \"6\\x1b[0m\", expected") != std::string::npos);
}

}  // namespace config_test
