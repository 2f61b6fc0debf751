#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "dataflow/base/grouped_digits.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace cli_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using faster::Image;
using faster::files::write_png;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int cores = 2;
constexpr int samples = 3;
constexpr int window = 120;

Words operator+(Words left, Words const& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

Words set(std::string const& key_value) { return {"--set", key_value}; }

Words const two_cores = set("accelerator.raster_cores=" + std::to_string(cores));
Words const small = two_cores + set("workload.samples.count=" + std::to_string(samples)) +
                    set("accelerator.window=" + std::to_string(window));
Words const engines{"decoupled", "lockstep"};

Words engine_is(std::string const& engine) { return set("simulation.engine=" + engine); }

/// A folder to run faster-sim in, with config.yaml: a built-in object in front of another.
class Workspace {
  public:
    Workspace() {
        write("config.yaml",
              "workload:\n"
              "  object: tomato_soup_can\n"
              "  pose: {translation_m: [0, 0, 0.65], rotation_deg: [120, 0, 0]}\n"
              "  scene:\n"
              "    table_height_m: 0.059\n"
              "    objects:\n"
              "      - {object: gelatin_box, translation_m: [0.03, 0.079, 0.586], rotation_deg: [123.7, -25.7, "
              "-16.1]}\n");
    }

    CommandResult operator()(Words const& arguments) const {
        return run_command(FASTER_SIM_BINARY, arguments, folder_.path());
    }
    CommandResult run(Words const& arguments) const { return (*this)(Words{"run", "config.yaml"} + arguments); }
    CommandResult record(Words const& arguments) const { return (*this)(Words{"record", "config.yaml"} + arguments); }

    void write(std::string const& name, std::string const& content) const { folder_.write(name, content); }
    fs::path operator/(std::string const& name) const { return folder_ / name; }
    std::string text(std::string const& name) const { return content_of(folder_ / name); }
    nlohmann::ordered_json json(std::string const& name) const { return nlohmann::ordered_json::parse(text(name)); }

    /// Paths of everything below a folder of the workspace, hidden files included, relative to that folder.
    std::set<std::string> tree(std::string const& name = ".") const {
        std::set<std::string> paths;
        for (auto const& entry : fs::recursive_directory_iterator(folder_ / name))
            paths.insert(entry.path().lexically_relative(folder_ / name).string());
        return paths;
    }

  private:
    TempFolder folder_;
};

Words fields_of(std::string const& line) {
    Words fields;
    std::istringstream stream(line + ",");
    for (std::string field; std::getline(stream, field, ',');)
        fields.push_back(field);
    return fields;
}

/// A CSV table with this header; each row is its first `keys` fields, joined by commas.
Words row_keys(std::string const& text, std::string const& header, std::size_t keys) {
    Words lines = lines_of(text);
    REQUIRE_FALSE(lines.empty());
    CHECK(lines.front() == header);
    CHECK(text.back() == '\n');
    CHECK_THAT(text, !Contains("\r"));
    std::size_t const columns = fields_of(header).size();
    Words found;
    for (std::size_t index = 1; index < lines.size(); ++index) {
        Words const fields = fields_of(lines[index]);
        CAPTURE(lines[index]);
        REQUIRE(fields.size() == columns);
        std::string key = fields[0];
        for (std::size_t field = 1; field < keys; ++field)
            key += "," + fields[field];
        found.push_back(key);
    }
    return found;
}

Words per_core(Words const& names) {
    Words rows;
    for (int core = 0; core < cores; ++core)
        for (std::string const& name : names)
            rows.push_back(std::to_string(core) + "," + name);
    return rows;
}

void check_same_tables(Workspace const& workspace, std::string const& found, std::string const& expected) {
    for (std::string const table : {"samples.csv", "fifos.csv", "loops.csv"}) {
        CAPTURE(table, found, expected);
        std::string const text = workspace.text(expected + "/" + table);
        CHECK_FALSE(text.empty());
        CHECK(workspace.text(found + "/" + table) == text);
    }
}

/// Bad input, and the folder is as it was.
void check_refused(Workspace const& workspace, Words const& arguments, Words const& parts) {
    std::string command;
    for (std::string const& word : arguments)
        command += word + " ";
    CAPTURE(command);
    std::set<std::string> const before = workspace.tree();
    CommandResult const result = workspace(arguments);
    check_bad_input(result, parts);
    CHECK(workspace.tree() == before);
}

void check_run_refused(Workspace const& workspace, Words const& arguments, Words const& parts) {
    check_refused(workspace, Words{"run", "config.yaml"} + small + arguments + Words{"--out", "out"}, parts);
}

/// A workspace with a trace of the small workload in "trace".
void record_small_trace(Workspace const& workspace) { require_done(workspace.record(small + Words{"--out", "trace"})); }

Words const replay = {"run", "config.yaml", "--trace", "trace", "--out", "out"};

TEST_CASE("A run prints its report and without --out writes nothing") {
    Workspace const workspace;
    std::set<std::string> const before = workspace.tree();
    CommandResult const result = workspace.run(small);
    require_done(result);
    CHECK_THAT(result.out, Contains("3 samples on 2 raster cores, window 120 x 120 px"));
    for (std::string const part :
         {"total", "Modules", "rasterizer", "Loops", "inlier_unit.sweep", "FIFOs", "edge_token"})
        CHECK_THAT(result.out, Contains(part));
    CHECK_THAT(result.out, !Contains("\r") && !Contains("\033"));
    CHECK(workspace.tree() == before);
}

TEST_CASE("A run's report says how many block RAMs it takes, as summary.json does") {
    Workspace const workspace;
    CommandResult const result = workspace.run(small + Words{"--out", "out"});
    require_done(result);
    double sum = 0;
    nlohmann::ordered_json const summary = workspace.json("out/summary.json");
    for (auto const& bram : summary.at("brams"))
        sum += bram.at("ramb36").get<double>();
    CHECK(sum > 0);
    std::ostringstream line;
    line << "\nBlock RAMs: " << sum << " RAMB36 in all";
    CHECK_THAT(result.out, Contains(line.str()));
    for (char const* const name : {"edge_map ", "object_map ", "depth_buffer "})
        CHECK_THAT(result.out, Contains(std::string("\n  ") + name));
    nlohmann::ordered_json const& resources = summary.at("resources");
    for (char const* const key : {"lut", "ff", "dsp", "ramb36"}) {
        double of_core = 0;
        for (char const* const parts : {"modules", "fifos", "memories"})
            for (auto const& part : resources.at(parts))
                of_core += part.at(key).get<double>();
        CHECK(of_core == Approx(resources.at("core").at(key).get<double>()));
        CHECK(2 * of_core == Approx(resources.at("cores").at(key).get<double>()));
    }
    CHECK(resources.at("cores").at("ramb36") == sum);
    std::ostringstream of_cores;
    auto const luts = static_cast<std::uint64_t>(std::llround(resources.at("cores").at("lut").get<double>()));
    of_cores << "\n  2 raster cores " << std::setw(20) << dataflow::grouped(luts) << ' ';
    CHECK_THAT(result.out, Contains(of_cores.str()));
    CHECK_THAT(result.out, Contains("of the XCZU9EG"));
    nlohmann::ordered_json const& power = summary.at("power");
    CHECK(power.at("energy_mj").at("typical").get<double>() ==
          Approx(power.at("total_w").at("typical").get<double>() * summary.at("milliseconds").get<double>()));
    CHECK_THAT(result.out, Contains("energy of the run"));
    CHECK(summary.at("timing").at("closes") == true);
}

TEST_CASE("A run writes exactly its six files with their headers and rows in order") {
    Workspace const workspace;
    CommandResult const result = workspace.run(small + Words{"--out", "new/out"});
    require_done(result);
    CHECK_THAT(result.out, Contains("written: new/out"));
    CHECK(workspace.tree() == std::set<std::string>{"config.yaml", "new", "new/out", "new/out/all_loops.csv",
                                                    "new/out/fifos.csv", "new/out/loops.csv", "new/out/poses.csv",
                                                    "new/out/samples.csv", "new/out/summary.json"});

    CHECK(row_keys(workspace.text("new/out/samples.csv"),
                   "sample,core,start_cycle,end_cycle,latency_cycles,valid_raster,valid_depth,inlier,valid_edge,"
                   "edge_inlier",
                   1) == Words{"0", "1", "2"});
    CHECK(row_keys(workspace.text("new/out/fifos.csv"),
                   "core,fifo,kind,depth,write_latency,writes,reads,full_stall_cycles,empty_stall_cycles,max_occupancy",
                   2) == per_core({"sample_vertex", "sample_raster", "sample_observation", "vertex", "area",
                                   "area_reciprocal", "command", "fragment_depth", "fragment_index", "edge_token",
                                   "edge_map", "observed_depth", "observed_edge", "result"}));
    CHECK(row_keys(workspace.text("new/out/loops.csv"),
                   "core,module,loop,ii_target,ii_recurrence,ii,depth,entries,iterations,port_conflict_cycles,"
                   "recurrence_cycles,limited_by",
                   3) ==
          per_core({"rasterizer,scan", "edge_map_builder,clear", "edge_map_builder,token", "edge_map_builder,output",
                    "inlier_unit,clear", "inlier_unit,fragment", "inlier_unit,sweep"}));
    CHECK_THAT(workspace.text("new/out/fifos.csv"), !Contains("auto"));
    // What loops.csv has to leave out stands behind its rows.
    std::string const loops = workspace.text("new/out/loops.csv"), all_loops = workspace.text("new/out/all_loops.csv");
    CHECK(all_loops.substr(0, loops.size()) == loops);
    CHECK(row_keys(loops.substr(0, loops.find('\n') + 1) + all_loops.substr(loops.size()),
                   loops.substr(0, loops.find('\n')),
                   3) == per_core({"vertex_transform,vertex", "observation_reader,read"}));
}

TEST_CASE("Without samples a run writes the columns of its counters, and cosim says that it compares nothing") {
    Workspace const workspace;
    require_done(workspace.record(small + set("workload.samples.count=0") + Words{"--out", "trace"}));
    for (bool const counted : {false, true}) {
        Words const hidden = set(std::string("accelerator.inlier_unit.hidden=") + (counted ? "counted" : "ignored"));
        require_done(workspace(replay + hidden));
        CHECK(workspace.text("out/samples.csv") ==
              std::string("sample,core,start_cycle,end_cycle,latency_cycles,valid_raster,valid_depth,inlier,valid_edge,"
                          "edge_inlier") +
                  (counted ? ",hidden,visible_top,visible_left,visible_bottom,visible_right\n" : "\n"));
    }
    CommandResult const cosim = workspace({"cosim", "trace"});
    if (!Contains("expected a program built with Verilator").match(cosim.err)) {
        require_done(cosim);
        CHECK(cosim.out == "trace: no samples, nothing was compared\n");
    }
}

TEST_CASE("A recorded trace replays to the tables of the direct run on both engines") {
    Workspace const workspace;
    record_small_trace(workspace);
    CHECK(workspace.tree("trace") ==
          std::set<std::string>{"depth.png", "edges.png", "samples.csv", "trace.yaml", "triangles.csv"});
    for (std::string const& engine : engines) {
        require_done(workspace.run(small + engine_is(engine) + Words{"--out", engine}));
        // The trace brings the number of samples and the window.
        require_done(
            workspace.run(two_cores + engine_is(engine) + Words{"--trace", "trace", "--out", engine + "_replayed"}));
        check_same_tables(workspace, engine + "_replayed", engine);
    }
    check_same_tables(workspace, "lockstep", "decoupled");
}

TEST_CASE("Repeated runs write the same bytes apart from the times of the host") {
    Workspace const workspace;
    for (std::string const& engine : engines) {
        Words const arguments = small + engine_is(engine) + Words{"--images", "1", "--out"};
        std::string const first = engine + "1", second = engine + "2";
        require_done(workspace.run(arguments + Words{first}));
        require_done(workspace.run(arguments + Words{second}));
        std::set<std::string> const files = workspace.tree(first);
        REQUIRE(workspace.tree(second) == files);
        for (std::string const& file : files) {
            CAPTURE(engine, file);
            if (file == "summary.json") {
                nlohmann::ordered_json one = workspace.json(first + "/" + file);
                nlohmann::ordered_json two = workspace.json(second + "/" + file);
                CHECK(one.erase("host") == 1);
                CHECK(two.erase("host") == 1);
                CHECK(one.dump() == two.dump());
            } else if (fs::is_regular_file(workspace / (first + "/" + file))) {
                CHECK((workspace.text(first + "/" + file) == workspace.text(second + "/" + file)));
            }
        }
    }
}

TEST_CASE("Recording twice writes the same bytes") {
    Workspace const workspace;
    record_small_trace(workspace);
    require_done(workspace.record(small + Words{"--out", "again"}));
    REQUIRE(workspace.tree("again") == workspace.tree("trace"));
    for (std::string const& file : workspace.tree("trace")) {
        CAPTURE(file);
        CHECK((workspace.text("again/" + file) == workspace.text("trace/" + file)));
    }
}

TEST_CASE("A run replaces the results of an older one") {
    Workspace const workspace;
    require_done(workspace.run(small + Words{"--images", "1", "--out", "out"}));
    require_done(workspace.run(small + set("workload.samples.count=2") + Words{"--out", "out"}));
    CHECK(workspace.tree("out") ==
          std::set<std::string>{"all_loops.csv", "fifos.csv", "loops.csv", "poses.csv", "samples.csv", "summary.json"});
    CHECK(lines_of(workspace.text("out/samples.csv")).size() == 1 + 2);
}

TEST_CASE("The cycle buckets of every module add up to the total") {
    Workspace const workspace;
    for (std::string const& engine : engines) {
        require_done(workspace.run(small + engine_is(engine) + Words{"--out", engine}));
        nlohmann::ordered_json const summary = workspace.json(engine + "/summary.json");
        auto const total = summary.at("total_cycles").get<std::uint64_t>();
        CHECK(total > 0);
        CHECK(summary.at("samples") == samples);
        CHECK(summary.at("modules").size() == cores * 8);
        for (auto const& row : summary.at("modules")) {
            CAPTURE(row.dump());
            std::uint64_t sum = 0;
            for (char const* const bucket :
                 {"busy_cycles", "fill_drain_cycles", "setup_cycles", "empty_stall_cycles", "full_stall_cycles",
                  "port_conflict_cycles", "recurrence_cycles", "idle_before_cycles", "idle_after_cycles"})
                sum += row.at(bucket).get<std::uint64_t>();
            CHECK(sum == total);
            std::uint64_t stalls = 0;
            for (auto const& fifo : row.at("stalls"))
                stalls += fifo.get<std::uint64_t>();
            CHECK(stalls ==
                  row.at("empty_stall_cycles").get<std::uint64_t>() + row.at("full_stall_cycles").get<std::uint64_t>());
        }
    }
}

TEST_CASE("The pictures of the first samples have their names, sizes and types") {
    Workspace const workspace;
    require_done(workspace.run(small + Words{"--images", "2", "--out", "out"}));
    std::set<std::string> names{"contact_sheet.png"};
    for (std::string const sample : {"sample_0000", "sample_0001"}) {
        for (std::string const picture : {"edges", "object", "depth", "overlay", "depth_map"})
            names.insert(sample + "_" + picture + ".png");
        for (std::string const picture : {"edges", "object"}) {
            CAPTURE(sample, picture);
            auto const map = faster::files::read_png8(workspace / ("out/images/" + sample + "_" + picture + ".png"));
            CHECK(map.height() == window);
            CHECK(map.width() == window);
            auto const count = [&map](int grey) { return std::count(map.pixels().begin(), map.pixels().end(), grey); };
            CHECK(count(255) > 0);
            CHECK(count(255) + count(0) == window * window);
        }
        auto const depth = faster::files::read_png16(workspace / ("out/images/" + sample + "_depth.png"));
        CHECK(depth.height() == window);
        CHECK(depth.width() == window);
    }
    CHECK(workspace.tree("out/images") == names);
}

TEST_CASE("More pictures than samples are as many as there are samples") {
    Workspace const workspace;
    require_done(workspace.run(small + Words{"--images", "99", "--out", "out"}));
    CHECK(workspace.tree("out/images").size() == samples * 5 + 1);
}

TEST_CASE("A wrong configuration is refused in one line") {
    Workspace const workspace;
    check_run_refused(workspace, set("accelerator.raster_corez=3"),
                      {"accelerator.raster_corez", "unknown key", "accelerator.raster_cores"});
    check_run_refused(workspace, set("accelerator.raster_cores=many"),
                      {"accelerator.raster_cores", "expected an integer"});
    check_run_refused(workspace, set("accelerator.raster_cores=0"), {"accelerator.raster_cores", "from 1 to"});
    check_run_refused(workspace, set("simulation.engine=warp"), {"simulation.engine", "expected"});
    check_run_refused(workspace, set("accelerator.raster_cores"), {"accelerator.raster_cores"});

    workspace.write("bad.yaml", "accelerator:\n  windw: 120\n");
    check_refused(workspace, {"run", "bad.yaml", "--out", "out"}, {"bad.yaml:2", "windw", "window"});
    workspace.write("bad.yaml", "accelerator:\n  window: wide\n");
    check_refused(workspace, {"run", "bad.yaml", "--out", "out"}, {"bad.yaml:2", "accelerator.window"});
    workspace.write("bad.yaml", "accelerator: [\n");
    check_refused(workspace, {"run", "bad.yaml", "--out", "out"}, {"bad.yaml"});
    check_refused(workspace, {"run", "missing.yaml", "--out", "out"}, {"missing.yaml", "no such file"});
    check_refused(workspace, {"record", "missing.yaml", "--out", "out"}, {"missing.yaml", "no such file"});
}

TEST_CASE("A bad mesh is refused in one line") {
    Workspace const workspace;
    Words const own_mesh = set("workload.object=./own.obj");
    check_run_refused(workspace, own_mesh, {"own.obj", "no such file"});
    workspace.write("own.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\n");
    check_run_refused(workspace, own_mesh, {"own.obj", "no triangles"});
    workspace.write("own.obj", "");
    check_run_refused(workspace, own_mesh, {"own.obj"});
    workspace.write("own.obj", "v 0 0 0\nv nan 0 0\nv 0 0.1 0\nf 1 2 3\n");
    check_run_refused(workspace, own_mesh, {"own.obj:2"});
    workspace.write("own.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
    require_done(workspace.run(small + own_mesh));
}

TEST_CASE("A bad depth image is refused in one line") {
    Workspace const workspace;
    Words const own_depth = set("workload.scene.depth_image=depth.png");
    check_run_refused(workspace, own_depth, {"depth.png", "no such file"});
    write_png(workspace / "depth.png", Image<std::uint8_t>(480, 640, 200));
    check_run_refused(workspace, own_depth, {"depth.png", "16"});
    write_png(workspace / "depth.png", Image<std::uint16_t>(240, 320, 700));
    check_run_refused(workspace, own_depth, {"depth.png", "640", "480"});
    write_png(workspace / "depth.png", Image<std::uint16_t>(480, 640, 700));
    require_done(workspace.run(small + own_depth + set("workload.camera.fx=570")));
}

TEST_CASE("A bad trace is refused in one line") {
    Workspace const workspace;
    check_refused(workspace, replay, {"trace", "no such folder"});
    record_small_trace(workspace);

    SECTION("when an explicit key contradicts it") {
        check_refused(workspace, replay + set("accelerator.window=100"), {"accelerator.window=100", "expected 120"});
    }
    SECTION("when --set names another one") {
        check_refused(workspace, replay + set("workload.trace=other"), {"workload.trace=other", "the trace trace"});
    }
    SECTION("when its triangles end too early") {
        Words const lines = lines_of(workspace.text("trace/triangles.csv"));
        std::string half;
        for (std::size_t index = 0; index < lines.size() / 2; ++index)
            half += lines[index] + "\n";
        workspace.write("trace/triangles.csv", half);
        check_refused(workspace, replay, {"samples.csv", "triangle"});
    }
    SECTION("when its triangles are cut within a line") {
        std::string const text = workspace.text("trace/triangles.csv");
        std::size_t const line = text.find('\n', text.size() / 2);
        std::size_t const comma = text.find(',', line);
        workspace.write("trace/triangles.csv", text.substr(0, comma));
        check_refused(workspace, replay, {"triangles.csv"});
    }
    SECTION("when its depth image has 8 bits") {
        write_png(workspace / "trace/depth.png", Image<std::uint8_t>(480, 640, 200));
        check_refused(workspace, replay, {"depth.png", "16"});
    }
    SECTION("when its depth image has another size") {
        write_png(workspace / "trace/depth.png", Image<std::uint16_t>(480, 600, 200));
        check_refused(workspace, replay, {"depth.png", "640"});
    }
    SECTION("when a file is missing") {
        fs::remove(workspace / "trace/edges.png");
        check_refused(workspace, replay, {"edges.png", "no such file"});
    }
}

TEST_CASE("A folder that cannot be written is refused in one line") {
    Workspace const workspace;
    workspace.write("file", "kept");
    for (std::string const command : {"run", "record"}) {
        check_refused(workspace, Words{command, "config.yaml"} + small + Words{"--out", "file/below/out"},
                      {"file/below/out", "cannot be written"});
        check_refused(workspace, Words{command, "config.yaml"} + small + Words{"--out", "file"}, {"file"});
        fs::create_directory(workspace / "used");
        workspace.write("used/file", "kept");
        check_refused(workspace, Words{command, "config.yaml"} + small + Words{"--out", "used"}, {"other files"});
        check_refused(workspace, Words{command, "config.yaml"} + small + Words{"--out", "."},
                      {"is the current folder"});
    }
    CHECK(workspace.text("file") == "kept");
}

TEST_CASE("help and help of a command are as --help") {
    auto const said = [](Words const& words) { return run_command(FASTER_SIM_BINARY, words, "/").out; };
    CHECK(said({"help"}) == said({"--help"}));
    CHECK(said({"help", "run"}) == said({"run", "--help"}));
    CHECK(said({"help"}).find("Subcommands:") != std::string::npos);
    CHECK(said({"help", "run"}).find("--set KEY=VALUE ...") == std::string::npos);  // but --set again
}

TEST_CASE("Wrong usage is refused in one line") {
    Workspace const workspace;
    check_refused(workspace, {}, {"subcommand"});
    check_refused(workspace, {"fly"},
                  {"unknown command fly",
                   "run, check, record, explore, whatif, sensitivities, size-fifos, compare, cosim, "
                   "sweep, schedule, edge-quality, grip, estimate, evaluate, experiment, keys"});
    check_refused(workspace, {"run"}, {"config"});
    check_refused(workspace, {"record", "config.yaml"}, {"--out"});
    check_refused(workspace, {"run", "config.yaml", "--speed", "9"},
                  {"--speed: unknown option (see faster-sim run --help)"});
    check_refused(workspace, {"run", "config.yaml", "--images", "2"}, {"--images", "--out"});
    check_refused(workspace, {"run", "config.yaml", "--images", "two", "--out", "out"}, {"--images"});
    for (char const* const option : {"--trace", "--out", "--events", "--vcd", "--report"})  // as of "$UNSET"
        check_refused(workspace, {"run", "config.yaml", option, ""}, {option, "is empty"});
    check_refused(workspace, {"run", ""}, {"config: is empty, expected CONFIG"});
    for (std::string const flag : {"--critical-path", "--force"})
        for (char const* const value : {"=3", "=no"})
            check_refused(workspace, {"run", "config.yaml", flag + value},
                          {flag + ": has a value, expected it without one (see faster-sim run --help)"});
    check_refused(workspace, {"cosim", "trace", "--no-forwarding=1"}, {"--no-forwarding: has a value"});
    check_refused(workspace, {"sweep", "merge", "a", "--out", ""},
                  {"--out: is empty, expected DIR (see faster-sim sweep merge --help)"});
    check_refused(workspace, {"sweep", "merge", "", "--out", "b"}, {"folders: is empty"});
    check_refused(workspace, {"sweep", "merge"}, {"folders is required (see faster-sim sweep merge --help)"});
    check_refused(workspace, {"run", "config.yaml", "-j", "0"},
                  {"--jobs: expected an integer from 1 to 1024, found 0 (see faster-sim run --help)"});
}

TEST_CASE("An unknown option is refused by its name, with the one it may have been meant to be") {
    Workspace const workspace;
    check_refused(workspace, {"run", "config.yaml", "--ot", "out/x"},
                  {"faster-sim: --ot: unknown option, did you mean --out? (see faster-sim run --help)"});
    check_refused(workspace, {"run", "config.yaml", "--ot=out/x"}, {"faster-sim: --ot: unknown option, did you"});
    check_refused(workspace, {"run", "--ot"}, {"--ot: unknown option, did you mean --out?"});
    check_refused(workspace, {"run", "config.yaml", "--sensitivity"}, {"did you mean --sensitivities?"});
    check_refused(workspace, {"run", "config.yaml", "--report-sample", "1"}, {"did you mean --report-samples?"});
    check_refused(workspace, {"run", "config.yaml", "--crit"}, {"did you mean --critical-path?"});
    check_refused(workspace, {"run", "config.yaml", "-x"}, {"-x: unknown option (see faster-sim run --help)"});
    check_refused(workspace, {"sweep", "merge", "a", "--out", "b", "--shard", "1/2"},
                  {"--shard: unknown option (see faster-sim sweep merge --help)"});
    for (std::string const option : {"--versoin", "-v"})
        check_refused(workspace, {option},
                      {option + ": unknown option, did you mean --version? (see faster-sim --help)"});
    check_refused(workspace, {"--versoin", "run"}, {"--versoin: unknown option, did you mean --version?"});
    check_refused(workspace, {"run", "--", "config.yaml", "-x"}, {"not expected"});
}

TEST_CASE("Completion of bash offers commands, options and keys") {
    auto const offered = [](std::string const& words) {
        std::string const script = "source " + std::string(FASTER_SOURCE_DIR) +
                                   "/scripts/completion.bash\nCOMP_WORDS=(" FASTER_SIM_BINARY " " + words +
                                   ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_faster_sim 2>/dev/null\n"
                                   "printf '%s\\n' \"${COMPREPLY[@]}\"";
        return lines_of(run_command("/bin/bash", {"-c", script}, "/").out);
    };
    CHECK(offered("ru") == Words{"run"});
    CHECK(offered("help ru") == Words{"run"});
    CHECK(offered("--") == Words{"--help", "--version"});
    CHECK(offered("sweep merg") == Words{"merge"});
    CHECK(offered("sweep merge --") == Words{"--help", "--out"});
    CHECK(offered("run config.yaml --report") == Words{"--report", "--report-samples"});
    for (std::string const option : {"--set", "--twin-set"})
        CHECK(offered("cosim trace " + option + " accelerator.clock_m") == Words{"accelerator.clock_mhz="});
}

TEST_CASE("A negative number of pictures is refused in one line") {
    check_refused(Workspace(), Words{"run", "config.yaml"} + small + Words{"--images", "-1", "--out", "out"},
                  {"--images"});
}

TEST_CASE("Help, version and keys go to stdout") {
    Workspace const workspace;
    for (Words const& arguments : {Words{"--help"}, Words{"run", "--help"}, Words{"--version"}, Words{"keys"}}) {
        CommandResult const result = workspace(arguments);
        require_done(result);
        CHECK_FALSE(result.out.empty());
    }
}

/// Intervals and depths of FIFOs as a synthesis report has them.
constexpr char const* report_of_tool =
    R"(<profile><ReportVersion><Version>2021.1</Version></ReportVersion><UserAssignments><TopModelName>top)"
    R"(</TopModelName></UserAssignments><PerformanceEstimates><SummaryOfLoopLatency></SummaryOfLoopLatency>)"
    R"(</PerformanceEstimates><ModuleInformation><Module><Name>inlier_unit</Name><PerformanceEstimates>)"
    R"(<SummaryOfLoopLatency><sweep><Name>sweep</Name><TripCount>9</TripCount><PipelineII>1</PipelineII>)"
    R"(<PipelineDepth>8</PipelineDepth></sweep></SummaryOfLoopLatency></PerformanceEstimates></Module>)"
    R"(</ModuleInformation><BindNode OPTYPE="fifo" VARIABLE="command" DEPTH="2"/></profile>)";

TEST_CASE(
    "A schedule's configuration is what was scheduled, whatever a preset says, and what it does not reach is told") {
    Workspace const workspace;
    workspace.write("report.xml", report_of_tool);
    Words const schedule =
        Words{"schedule", "report.xml", "--config", "config.yaml", "--out", "scheduled.yaml"} + small;
    CommandResult const deep = workspace(schedule + set("accelerator.architecture=early_exit"));
    require_done(deep);
    CHECK_THAT(deep.out, Contains("accelerator.fifos.command.depth"));
    CommandResult const keys = workspace({"run", "scheduled.yaml", "--out", "out"});
    require_done(keys);
    CHECK(workspace.json("out/summary.json").at("configuration").at("accelerator.fifos.command.depth").at("value") ==
          2);
    CHECK_THAT(deep.out,
               Contains("scheduled  " +
                        dataflow::grouped(workspace.json("out/summary.json").at("total_cycles").get<std::uint64_t>())));
    CommandResult const slow = workspace(schedule + set("accelerator.loops.inlier_unit.sweep.recurrence_ii=3"));
    require_done(slow);
    CHECK_THAT(slow.out, Contains("inlier_unit.sweep: 1 of the report, 3 here, by recurrence_ii"));
}

TEST_CASE("A deadlock prints the same wait-for cycle on both engines and writes it, but no results") {
    Workspace const workspace;
    std::set<std::string> const before = workspace.tree();
    std::map<std::string, std::string> reports;
    for (std::string const& engine : engines) {
        CAPTURE(engine);
        CommandResult const result = workspace.run(small + set("accelerator.fifos.fragment_depth.depth=1") +
                                                   engine_is(engine) + Words{"--images", "1", "--out", "new/out"});
        CHECK(result.exit_code == 3);
        CHECK(result.out.empty());
        for (std::string const part :
             {"deadlock", "wait-for cycle", "rasterizer", "inlier_unit", "fragment_depth",
              "src/modules/rasterizer/rasterizer.cpp:", "src/modules/inlier_unit/inlier_unit.cpp:"})
            CHECK_THAT(result.err, Contains(part));
        std::set<std::string> after = before;
        after.insert({"new", "new/out", "new/out/summary.json"});
        CHECK(workspace.tree() == after);
        auto const summary = workspace.json("new/out/summary.json");
        CHECK(summary.count("samples") == 0);
        auto const& deadlock = summary.at("deadlock");
        CHECK(deadlock.at("cycle") > 0);
        CHECK(deadlock.at("stuck").size() >= deadlock.at("wait_cycle").size());
        REQUIRE(deadlock.at("wait_cycle").size() > 1);
        std::string waits_for = deadlock.at("wait_cycle").back().at("waits_for");
        for (auto const& process : deadlock.at("wait_cycle")) {  // each is waited for by the one before
            CHECK(process.at("process") == waits_for);
            waits_for = process.at("waits_for");
            CHECK_THAT(process.at("source").get<std::string>(), Contains("src/modules/"));
            CHECK(process.at("occupancy") <= process.at("capacity"));
        }
        reports[engine] = result.err;
    }
    CHECK(reports["lockstep"] == reports["decoupled"]);
}

}  // namespace cli_test
