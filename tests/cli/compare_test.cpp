#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace compare_test {

using namespace faster::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::string const config = FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml";
fs::path const traces = fs::path(FASTER_SOURCE_DIR) / "traces";

/// A folder of runs to compare.
class Runs {
  public:
    /// Replays a trace on two cores into the folder `out`, with further settings.
    void run(std::string const& out, fs::path const& trace, Words const& settings = {}) const {
        Words arguments{"run", config, "--out", out};
        arguments.insert(arguments.end(), {"--trace", trace.string(), "--set", "accelerator.raster_cores=2"});
        for (std::string const& setting : settings) {
            arguments.emplace_back("--set");
            arguments.push_back(setting);
        }
        require_done(run_command(FASTER_SIM_BINARY, arguments, folder_.path()));
    }

    CommandResult compare(Words arguments) const {
        arguments.insert(arguments.begin(), "compare");
        return run_command(FASTER_SIM_BINARY, arguments, folder_.path());
    }

    std::string text(std::string const& file) const { return content_of(folder_ / file); }

    /// Replaces the first `found` in a file.
    void edit(std::string const& file, std::string const& found, std::string const& replacement) const {
        std::string content = text(file);
        auto const at = content.find(found);
        REQUIRE(at != std::string::npos);
        folder_.write(file, content.replace(at, found.size(), replacement));
    }

    /// Expects exit code 2, one line on stderr that contains `parts`, and nothing on stdout.
    void check_refused(Words const& arguments, Words const& parts) const {
        CommandResult const result = compare(arguments);
        CAPTURE(arguments, result.err);
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        CHECK(lines_of(result.err).size() == 1);
        for (std::string const& part : parts)
            CHECK_THAT(result.err, Contains(part));
    }

    TempFolder const& folder() const { return folder_; }

  private:
    TempFolder folder_;
};

/// The folder "a" with a run; `edit` is what happens to it before it is refused.
void check_edited_run_refused(std::string const& file, std::string const& found, std::string const& replacement,
                              Words const& parts) {
    Runs const runs;
    runs.run("a", traces / "one_triangle");
    runs.edit("a/" + file, found, replacement);
    runs.check_refused({"a", "a"}, parts);
}

TEST_CASE("Compared runs of the same machine are identical, in one line") {
    Runs const runs;
    runs.run("a", traces / "edge_heavy");
    runs.run("b", traces / "edge_heavy");
    CommandResult const result = runs.compare({"a", "b"});
    require_done(result);
    CHECK(lines_of(result.out).size() == 1);
    CHECK_THAT(result.out, Contains("identical") && Contains("5 samples"));
}

TEST_CASE("Comparing runs of other FIFO depths says what moved and that results did not") {
    Runs const runs;
    runs.run("a", traces / "edge_heavy");
    runs.run("b", traces / "edge_heavy", {"accelerator.fifos.command.depth=16", "accelerator.fifo_rules=spec"});
    CommandResult const result = runs.compare({"a", "b", "--top", "2", "--json", "comparison.json"});
    require_done(result);
    for (std::string const part :
         {"Configuration: 2 of ", "  accelerator.fifos.command.depth: 2 -> 16\n", "  cycles  18,803 ",
          "Results: the same in all 5 samples", "  command.kind: \"shift_register\" -> \"memory\"\n",
          "  command full_stall_cycles ", "  command max_occupancy  2 ", "more (--top)", "median latency_cycles"})
        CHECK_THAT(result.out, Contains(part));

    auto const json = nlohmann::json::parse(runs.text("comparison.json"));
    CHECK(json.at("format") == "faster-comparison");
    CHECK(json.at("total_cycles").at("a") == 18803);
    CHECK(json.at("results").at("equal") == true);
    CHECK(json.at("figures").at("module_cycles").size() > 2);
    CHECK(entries_in(runs.folder().path()) == 3);
}

TEST_CASE("Comparing engines finds the engine and nothing else") {
    Runs const runs;
    runs.run("a", traces / "full_window", {"simulation.engine=decoupled"});
    runs.run("b", traces / "full_window", {"simulation.engine=lockstep"});
    CommandResult const result = runs.compare({"a", "b"});
    require_done(result);
    CHECK_THAT(result.out, Contains("simulation.engine: \"decoupled\" -> \"lockstep\"") &&
                               Contains("Figures: the same, summed over cores"));
}

TEST_CASE("Hidden pixels are columns more in samples.csv, and change nothing else") {
    Runs const runs;
    runs.run("a", traces / "edge_heavy");
    runs.run("b", traces / "edge_heavy", {"accelerator.inlier_unit.hidden=counted"});
    CommandResult const result = runs.compare({"a", "b"});
    require_done(result);
    CHECK_THAT(result.out, Contains("accelerator.inlier_unit.hidden: \"ignored\" -> \"counted\"") &&
                               Contains("Results: the same in all"));
    Words const plain = lines_of(runs.text("a/samples.csv")), counted = lines_of(runs.text("b/samples.csv"));
    REQUIRE(plain.size() == counted.size());
    CHECK(counted[0] == plain[0] + ",hidden,visible_top,visible_left,visible_bottom,visible_right");
    for (std::size_t i = 1; i < plain.size(); ++i)
        CHECK(counted[i].substr(0, plain[i].size() + 1) == plain[i] + ",");
    CHECK(runs.text("a/fifos.csv") == runs.text("b/fifos.csv"));
    CHECK(runs.text("a/all_loops.csv") == runs.text("b/all_loops.csv"));
}

TEST_CASE("A sample that scores differently fails the comparison") {
    Runs const runs;
    fs::copy(traces / "one_triangle", runs.folder() / "trace");
    runs.run("a", runs.folder() / "trace");
    runs.edit("trace/triangles.csv", "480,384", "480,400");  // one pixel wider: a column with one more covered pixel
    runs.run("b", runs.folder() / "trace");
    CommandResult const result = runs.compare({"a", "b"});
    CHECK(result.exit_code == 1);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, Contains("Configuration: the same") && Contains("Results: 1 of 1 samples differ") &&
                               Contains("sample 0: valid_raster 15 -> "));
}

TEST_CASE("Runs with other samples fail the comparison, and are compared all the same") {
    Runs const runs;
    runs.run("a", traces / "edge_heavy");
    runs.run("b", traces / "one_triangle", {"accelerator.raster_cores=1"});
    CommandResult const result = runs.compare({"a", "b", "--json", "comparison.json"});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, Contains("note: A has 2 raster cores, B 1") && Contains("note: A has 5 samples, B 1") &&
                               Contains("Modules: where the cycles went"));
    CHECK(nlohmann::json::parse(runs.text("comparison.json")).at("results").at("compared_samples") == 1);
}

TEST_CASE("Comparing with a folder without a run is refused") {
    Runs const runs;
    runs.run("a", traces / "one_triangle");
    fs::create_directory(runs.folder() / "empty");
    runs.check_refused({"a", "empty"}, {"empty/summary.json: no such file"});
    runs.check_refused({"gone", "a"}, {"gone: no such folder"});
    runs.check_refused({"a"}, {"run_b", "required"});
    runs.check_refused({"a", "a", "--top", "-1"}, {"--top"});
    runs.check_refused({"a", "a", "--top", "some"}, {"--top"});
    for (std::string const file : {"samples.csv", "fifos.csv", "loops.csv"}) {
        fs::rename(runs.folder() / ("a/" + file), runs.folder() / "aside");
        runs.check_refused({"a", "a"}, {"a/" + file + ": no such file"});
        fs::rename(runs.folder() / "aside", runs.folder() / ("a/" + file));
    }
    runs.check_refused({"a", "a", "--json", "empty"}, {"empty: is a folder"});
    runs.check_refused({"a", "a", "--json", "/proc/gone/file"}, {"gone/file: cannot be written"});
    runs.check_refused({"a", "a", "--json", "a/fifos.csv"}, {"--json a/fifos.csv: would replace a, which is read"});
}

TEST_CASE("Comparing with a run of another format or version is refused") {
    check_edited_run_refused("summary.json", "faster-summary", "faster-something", {"a/summary.json: format"});
    check_edited_run_refused("summary.json", "\"version\": 1", "\"version\": 7", {"version = 7, expected 1"});
}

TEST_CASE("Comparing with a run of another design says so") {
    Runs const runs;
    runs.run("a", traces / "one_triangle");
    runs.run("b", traces / "one_triangle");
    runs.folder().write("b/samples.csv", "sample,core,start_cycle,end_cycle,latency_cycles,sum\n");
    // Whoever edited the file of a run of this very program is told the column.
    runs.check_refused({"a", "b"}, {"b/samples.csv:1: no column valid_raster in the header, expected sample,core,",
                                    "valid_edge,edge_inlier\n"});
    runs.edit("b/summary.json", "\"program\": \"faster-sim\"", "\"program\": \"convolution\"");
    runs.check_refused({"a", "b"},
                       {"b: a run of convolution, whose design is another one, expected one of faster-sim\n"});
}

TEST_CASE("Comparing with a file that was cut off is refused, wherever the cut is") {
    Runs const runs;
    runs.run("a", traces / "one_triangle");
    for (std::string const file : {"summary.json", "samples.csv", "fifos.csv", "loops.csv", "all_loops.csv"}) {
        std::string const whole = runs.text("a/" + file);
        for (int part = 0; part < 8; ++part) {
            CAPTURE(file, part);
            runs.folder().write("a/" + file, whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 8));
            runs.check_refused({"a", "a"}, {"a/" + file});
        }
        runs.folder().write("a/" + file, whole);
    }
    require_done(runs.compare({"a", "a"}));
}

TEST_CASE("Comparing with tables that are wrong or contradict each other is refused") {
    check_edited_run_refused("samples.csv", "edge_inlier", "inlier_edge", {"a/samples.csv:1: no column edge_inlier"});
    check_edited_run_refused("fifos.csv", "max_occupancy", "occupancy", {"a/fifos.csv:1: no column max_occupancy"});
    check_edited_run_refused("loops.csv", "iterations", "rounds", {"a/loops.csv:1: no column iterations"});
    check_edited_run_refused("samples.csv", ",900,", ",nine,", {"a/samples.csv:2: column valid_depth = nine"});
    check_edited_run_refused("fifos.csv", "shift_register,2", "shift_register,two", {"a/fifos.csv:2: column depth"});
    check_edited_run_refused("summary.json", "\"samples\": 1", "\"samples\": 2", {"a/samples.csv: 1 rows, expected 2"});
    check_edited_run_refused("loops.csv", "1,rasterizer", "0,rasterizer", {"a/loops.csv:"});
    check_edited_run_refused("all_loops.csv", "vertex_transform,vertex,1", "vertex_transform,vertex,2",
                             {"a/all_loops.csv:", "column ii_target = 2, expected 1 as in summary.json"});
}

}  // namespace compare_test
