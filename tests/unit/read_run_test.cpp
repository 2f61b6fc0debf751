#include "dataflow/tools/compare/read_run.hpp"

#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace read_run_test {

using Catch::Matchers::Contains;
using dataflow::NamedCycles;
using dataflow::runs::read_run;
using dataflow::runs::RunRecord;
using faster::Counters;
using faster::test::content_of;
using faster::test::input_error_text;
using faster::test::TempFolder;

char const* const summary = R"({
  "format": "faster-summary", "version": 1, "total_cycles": 100, "milliseconds": 0.0005, "samples": 2,
  "raster_cores": 1,
  "modules": [{"core": 0, "module": "rasterizer", "busy_cycles": 70, "idle_cycles": 30, "nap_cycles": 4,
               "waits": {"busy_cycles": 1}, "nested_cycles": {"command": 2}, "share": 0.5}],
  "fifos": [{"core": 0, "fifo": "command", "kind": "memory", "depth": 4, "write_latency": 3, "writes": 9, "reads": 8,
             "full_stall_cycles": 7, "empty_stall_cycles": 6, "max_occupancy": 5}],
  "loops": [{"core": 0, "module": "rasterizer", "loop": "scan", "ii_target": 1, "ii_recurrence": 2, "ii": 3,
             "depth": 4, "entries": 5, "iterations": 6, "port_conflict_cycles": 7, "recurrence_cycles": 8,
             "limited_by": "recurrence"},
            {"core": 0, "module": "vertex_transform", "loop": "vertex", "ii_target": 1, "ii_recurrence": 1, "ii": 1,
             "depth": 4, "entries": 5, "iterations": 6, "port_conflict_cycles": 0, "recurrence_cycles": 0,
             "limited_by": ""}],
  "configuration": {"simulation.engine": {"value": "lockstep", "default": false},
                    "accelerator.clock_mhz": {"value": 200.0, "default": true}}
})";

char const* const samples =
    "sample,core,start_cycle,end_cycle,latency_cycles,valid_raster,valid_depth,inlier,valid_edge,edge_inlier\n"
    "0,0,1,10,10,11,12,13,14,15\n"
    "1,0,5,99,95,0,0,0,0,0\n";

char const* const fifos =
    "core,fifo,kind,depth,write_latency,writes,reads,full_stall_cycles,empty_stall_cycles,max_occupancy\n"
    "0,command,memory,4,3,9,8,7,6,5\n";

char const* const loops =
    "core,module,loop,ii_target,ii_recurrence,ii,depth,entries,iterations,port_conflict_cycles,recurrence_cycles,"
    "limited_by\n"
    "0,rasterizer,scan,1,2,3,4,5,6,7,8,recurrence\n";

/// The output folder of a very small run.
class RunFolder {
  public:
    RunFolder() {
        folder_.write("summary.json", summary);
        folder_.write("samples.csv", samples);
        folder_.write("fifos.csv", fifos);
        folder_.write("loops.csv", loops);
    }

    RunRecord read() const { return read_run(folder_.path()); }

    /// The message about the folder after `found` in one of its files was replaced.
    std::string error_with(std::string const& file, std::string const& found, std::string const& replacement) const {
        std::string text = content_of(folder_ / file);
        auto const at = text.find(found);
        REQUIRE(at != std::string::npos);
        folder_.write(file, text.substr(0, at) + replacement + text.substr(at + found.size()));
        std::string message = input_error_text([this] { (void)read(); });
        folder_.write(file, text);
        return message;
    }

  private:
    TempFolder folder_;
};

TEST_CASE("A run's folder is read back into a record", "[runs]") {
    RunRecord const run = RunFolder().read();
    CHECK(run.total_cycles == 100);
    CHECK(run.milliseconds == 0.0005);
    CHECK(run.raster_cores == 1);
    REQUIRE(run.configuration.size() == 2);
    CHECK(run.configuration[0].key == "simulation.engine");
    CHECK(run.configuration[0].value == "\"lockstep\"");
    CHECK(run.configuration[1].value == "200.0");
    REQUIRE(run.fifos.size() == 1);
    CHECK(run.fifos[0].name() == "command");
    CHECK(run.fifos[0].kind_name == "memory");
    CHECK(run.fifos[0].max_occupancy == 5);
    REQUIRE(run.loops.size() == 2);
    CHECK(run.loops[0].name() == "rasterizer.scan");
    CHECK(run.loops[0].ii == 3);
    CHECK(run.loops[0].limited_by == "recurrence");
    REQUIRE(run.samples.size() == 2);
    CHECK(run.samples[0].latency_cycles() == 10);
    CHECK(run.samples[0].counters == Counters{11, 12, 13, 14, 15});
}

TEST_CASE("A module has the cycle classes its row has, whatever they are called", "[runs]") {
    RunRecord const run = RunFolder().read();
    REQUIRE(run.modules.size() == 1);
    CHECK(run.modules[0].name() == "rasterizer");
    CHECK(run.modules[0].classes ==
          std::vector<NamedCycles>{{"busy_cycles", 70}, {"idle_cycles", 30}, {"nap_cycles", 4}});
}

/// The message about a run in whose summary `found` was replaced.
std::string summary_error(std::string const& found, std::string const& replacement) {
    return RunFolder().error_with("summary.json", found, replacement);
}

TEST_CASE("A summary that is none is refused", "[runs]") {
    CHECK_THAT(summary_error("faster-summary", "other"),
               Contains("summary.json: format = \"other\", expected faster-summary"));
    CHECK_THAT(summary_error("\"version\": 1", "\"version\": 2"), Contains("version = 2, expected 1"));
    CHECK_THAT(summary_error("\"version\": 1, ", ""), Contains("no key version"));
    CHECK_THAT(summary_error("  \"loops\"", "}"), Contains("summary.json:8: is cut off or no JSON from here on"));
    CHECK_THAT(summary_error("0.0005", "1e999"), Contains("beyond all limits"));
    CHECK_THAT(summary_error(summary, "[]"), Contains("summary.json: an array of 0, expected an object"));
    CHECK_THAT(summary_error(summary, ""), Contains("summary.json:1: is cut off"));
}

TEST_CASE("A value of the summary that cannot be is refused by its key", "[runs]") {
    CHECK_THAT(summary_error("\"total_cycles\": 100", "\"total_cycles\": -1"),
               Contains("total_cycles = -1, expected an integer in 0..9007199254740991"));
    CHECK_THAT(summary_error("0.0005", "\"much\""), Contains("milliseconds = \"much\", expected a number"));
    CHECK_THAT(summary_error("\"busy_cycles\": 70", "\"busy_cycles\": 0.5"),
               Contains("modules[0].busy_cycles = 0.5, expected"));
    CHECK_THAT(summary_error("\"depth\": 4, \"write", "\"write"), Contains("fifos[0]: no key depth, expected one"));
    CHECK_THAT(summary_error("\"limited_by\": \"\"", "\"limited_by\": {}"),
               Contains("loops[1].limited_by = an object, expected text"));
    CHECK_THAT(summary_error("{\"value\": 200.0, \"default\": true}", "200"),
               Contains("configuration.accelerator.clock_mhz = 200, expected an object"));
    CHECK_THAT(summary_error("\"fifos\"", "\"fifos\": 3, \"others\""), Contains("fifos = 3, expected an array"));
}

TEST_CASE("Tables that lack a row or have one twice are refused", "[runs]") {
    CHECK_THAT(summary_error("\"raster_cores\": 1", "\"raster_cores\": 2"),
               Contains("modules = an array of 1, expected a row for each item of each of the 2 raster cores"));
    CHECK_THAT(summary_error("\"vertex_transform\", \"loop\": \"vertex\"", "\"rasterizer\", \"loop\": \"scan\""),
               Contains("loops[1].core = 0, expected one row only for its rasterizer.scan"));
    CHECK_THAT(summary_error("\"core\": 0", "\"core\": 1"),
               Contains("modules[0].core = 1, expected an integer in 0..0"));
}

TEST_CASE("A design without loops and FIFOs has results that can be read", "[runs]") {
    TempFolder const folder;
    std::string text = summary;
    for (char const* const table : {"\"fifos\": [", "\"loops\": ["}) {
        std::size_t const begin = text.find(table) + std::string(table).size();
        text.erase(begin, text.find(']', begin) - begin);
    }
    folder.write("summary.json", text);
    folder.write("samples.csv", samples);
    auto const header = [](std::string const& csv) { return csv.substr(0, csv.find('\n') + 1); };
    folder.write("fifos.csv", header(fifos));
    folder.write("loops.csv", header(loops));
    RunRecord const run = read_run(folder.path());
    CHECK(run.fifos.empty());
    CHECK(run.loops.empty());
    CHECK(run.modules.size() == 1);
}

TEST_CASE("A sample may end before the module that begins samples has come to it", "[runs]") {
    RunFolder const folder;
    CHECK(folder.error_with("samples.csv", "5,99,95", "50,9,0") == "(no error)");
    CHECK(folder.error_with("samples.csv", "5,99,95", "107,99,0") == "(no error)");
}

TEST_CASE("Samples that do not fit the run are refused by their line", "[runs]") {
    RunFolder const folder;
    auto const error = [&folder](std::string const& found, std::string const& replacement) {
        return folder.error_with("samples.csv", found, replacement);
    };
    CHECK_THAT(error(",inlier", ",outlier"), Contains("samples.csv:1: no column inlier in the header"));
    CHECK_THAT(error("11,12", "11,x"), Contains("samples.csv:2: column valid_depth = x, expected an integer"));
    CHECK_THAT(error("1,0,5", "2,0,5"), Contains("samples.csv:3: column sample = 2, expected 1"));
    CHECK_THAT(error("5,99,95", "5,100,96"), Contains("samples.csv:3: column end_cycle = 100, expected"));
    CHECK_THAT(error("5,99,95", "5,99,94"), Contains("latency_cycles = 94, expected 95, by start_cycle and end_cycle"));
    CHECK_THAT(error("5,99,95", "50,9,95"), Contains("expected 0, by start_cycle and end_cycle"));
    CHECK_THAT(error("1,0,5,99,95,0,0,0,0,0\n", ""), Contains("samples.csv: 1 rows, expected 2"));
    CHECK_THAT(error("0,0,0,0\n", "0"), Contains("samples.csv:3: 7 cells, expected 10"));
}

TEST_CASE("Tables that contradict the summary are refused by their line", "[runs]") {
    RunFolder const folder;
    CHECK_THAT(folder.error_with("fifos.csv", "9,8", "9,88"), Contains("fifos.csv:2: column reads = 88, expected 8"));
    CHECK_THAT(folder.error_with("fifos.csv", "memory", ""), Contains("kind = nothing, expected memory"));
    CHECK_THAT(folder.error_with("fifos.csv", "0,command", "0,vertex"), Contains("a row for core 0, fifo vertex"));
    CHECK_THAT(folder.error_with("fifos.csv", "0,command,memory,4,3,9,8,7,6,5\n", ""), Contains("0 rows, expected 1"));
    CHECK_THAT(folder.error_with("fifos.csv", "7,6,5\n", "7,6,5\n0,command,memory,4,3,9,8,7,6,5\n"),
               Contains("fifos.csv:3: a second row for core 0, fifo command"));
    CHECK_THAT(folder.error_with("loops.csv", ",limited_by", ""), Contains("loops.csv:1: no column limited_by"));
    CHECK_THAT(folder.error_with("loops.csv", "1,2,3", "1,2,x"), Contains("loops.csv:2: column ii = x, expected 3"));
    CHECK_THAT(folder.error_with("loops.csv", "0,rasterizer,scan,1,2,3,4,5,6,7,8,recurrence\n", ""),
               Contains("loops.csv: 0 rows, expected 1"));
}

TEST_CASE("A folder without results is refused", "[runs]") {
    TempFolder const folder;
    CHECK_THAT(input_error_text([&] { (void)read_run(folder.path()); }), Contains("summary.json: no such file"));
    CHECK_THAT(input_error_text([&] { (void)read_run(folder / "gone"); }), Contains("gone: no such folder"));
    folder.write("file", "");
    CHECK_THAT(input_error_text([&] { (void)read_run(folder / "file"); }),
               Contains("file: is a file, expected a folder: the output of "));
    folder.write("summary.json", R"({"format": "faster-summary", "version": 1, "deadlock": {"cycle": 7}})");
    CHECK_THAT(input_error_text([&] { (void)read_run(folder.path()); }),
               Contains("summary.json: deadlock.cycle = 7, expected a run that ended"));
}

}  // namespace read_run_test
