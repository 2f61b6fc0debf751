#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "faster/dataflow_names.hpp"
#include "support/on_terminal.hpp"
#include "support/report_page.hpp"
#include "support/sweep_workspace.hpp"

namespace sweep_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;
using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(std::string const& csv) {
    Words const lines = lines_of(csv);
    Words const names = cells_of(lines.at(0));
    std::vector<Row> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        Words const cells = cells_of(lines[i]);
        REQUIRE(cells.size() == names.size());
        rows.emplace_back();
        for (std::size_t k = 0; k < names.size(); ++k)
            rows.back()[names[k]] = cells[k];
    }
    return rows;
}

template <class Cell> Cell sum_of(Json const& rows, Words const& names) {
    Cell sum = 0;
    for (Json const& row : rows)
        for (std::string const& name : names)
            sum += row.at(name).get<Cell>();
    return sum;
}

/// `faster-sim run` of a point.
CommandResult run_of(SweepWorkspace const& workspace, Row const& row) {
    Words words{"run", "config.yaml", "--out", "run", "--set", "accelerator.window=40"};
    if (row.at("design") == "quick.yaml")
        words.insert(words.end(), {"--set", "accelerator.inlier_unit.neighbour_access=window"});
    for (auto const& [key, value] : row)
        if (key.find('.') != std::string::npos)
            words.insert(words.end(), {"--set", key + "=" + value});
    return workspace.tool(words);
}

void check_against_run(SweepWorkspace const& workspace, Row const& row) {
    CAPTURE(row.at("point"));
    CommandResult const result = run_of(workspace, row);
    if (row.at("status") == "deadlock") {
        CHECK(result.exit_code == 3);
        CHECK(row.at("total_cycles").empty());
        CHECK_THAT(row.at("message"), Contains(" -> "));
        return;
    }
    require_done(result);
    Json const run = workspace.summary("run");
    CHECK(row.at("status") == "done");
    CHECK(row.at("message").empty());
    CHECK(row.at("total_cycles") == run["total_cycles"].dump());
    CHECK(std::stod(row.at("milliseconds")) == run["milliseconds"].get<double>());
    auto const whole = [&row](std::string const& column) { return std::stoull(row.at(column)); };
    using Count = unsigned long long;
    CHECK(whole("stall_cycles") == sum_of<Count>(run["modules"], {"empty_stall_cycles", "full_stall_cycles"}));
    CHECK(whole("port_conflict_cycles") == sum_of<Count>(run["modules"], {"port_conflict_cycles"}));
    CHECK(whole("fifo_full_stall_cycles") == sum_of<Count>(run["fifos"], {"full_stall_cycles"}));
    CHECK(whole("fifo_empty_stall_cycles") == sum_of<Count>(run["fifos"], {"empty_stall_cycles"}));
    for (char const* const column : {"ramb36", "lut", "ff", "dsp"})
        CHECK(std::stod(row.at(column)) == run["resources"]["cores"][column].get<double>());
}

TEST_CASE("Every point of a sweep has what faster-sim run finds, cell for cell", "[sweeps]") {
    SweepWorkspace const workspace;
    CommandResult const result = workspace.sweep("out");
    require_done(result);
    CHECK_THAT(result.out, Contains("24 points: 16 done, 8 deadlocked, 0 failed"));
    std::vector<Row> const rows = rows_of(workspace.text("out/results.csv"));
    REQUIRE(rows.size() == 24);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].at("point") == std::to_string(i));
        check_against_run(workspace, rows[i]);
    }
    CHECK_FALSE(workspace.has("out/events"));
}

TEST_CASE("A sweep finds the same whatever the number of processes, and by shards that are merged", "[sweeps]") {
    SweepWorkspace const workspace;
    require_done(workspace.sweep("one", {"-j", "1"}));
    require_done(workspace.sweep("four", {"-j", "4"}));
    Words folders;
    for (std::string const i : {"1", "2", "3"}) {
        require_done(workspace.sweep("shard" + i, {"--shard", i + "/3"}));
        CHECK(lines_of(workspace.text("shard" + i + "/results.csv")).size() == 9);
        folders.push_back("shard" + i);
    }
    Words merge{"sweep", "merge", "--out", "merged"};
    merge.insert(merge.end(), folders.begin(), folders.end());
    require_done(workspace.tool(merge));
    for (std::string const file : {"/results.csv", "/index.html", "/sweep.json"}) {
        CHECK(workspace.text("four" + file) == workspace.text("one" + file));
        CHECK(workspace.text("merged" + file) == workspace.text("one" + file));
    }
}

TEST_CASE("Merging says what is missing, and keeps what is there", "[sweeps]") {
    SweepWorkspace const workspace;
    require_done(workspace.sweep("a", {"--shard", "1/2"}));
    require_done(workspace.sweep("b", {"--shard", "2/2"}));
    CommandResult const half = workspace.tool({"sweep", "merge", "a", "--out", "merged"});
    CHECK(half.exit_code == 1);
    CHECK_THAT(half.out, Contains("12 of 24 points: 8 done, 4 deadlocked, 0 failed"));
    CHECK_THAT(half.err, Contains("12 of 24 points are missing: point 12 (design=quick.yaml workload.samples.count=1"));
    CHECK(lines_of(workspace.text("merged/results.csv")).size() == 13);
    require_done(workspace.tool({"sweep", "merge", "b", "--out", "merged"}));
    require_done(workspace.sweep("whole"));
    CHECK(workspace.text("merged/results.csv") == workspace.text("whole/results.csv"));
}

TEST_CASE("A sweep that is done does nothing again, and one with more points only those", "[sweeps]") {
    SweepWorkspace const workspace;
    require_done(workspace.sweep("out"));
    std::string const journal = workspace.text("out/journal");
    CommandResult const again = workspace.sweep("out");
    CHECK_THAT(again.out, Contains("24 of 24 points are done already"));
    CHECK(workspace.text("out/journal") == journal);
    std::string sweep = workspace.text("sweep.yaml");
    sweep.replace(sweep.find("values: [1, 2]"), 14, "values: [1, 2, 3]");
    workspace.folder().write("sweep.yaml", sweep);
    CommandResult const more = workspace.sweep("out");
    require_done(more);
    CHECK_THAT(more.out, Contains("24 of 36 points are done already"));
    CHECK(workspace.text("out/journal").rfind(journal, 0) == 0);
    require_done(workspace.sweep("fresh"));
    CHECK(workspace.text("out/results.csv") == workspace.text("fresh/results.csv"));
    CHECK(workspace.text("out/index.html") == workspace.text("fresh/index.html"));
}

TEST_CASE("A sweep in the folder of another is refused by name", "[sweeps]") {
    SweepWorkspace const workspace;
    require_done(workspace.sweep("out"));
    std::string const before = workspace.text("out/results.csv");
    std::string sweep = workspace.text("sweep.yaml");
    sweep.replace(sweep.find("values: [1, 2, 8]"), 17, "values: [1, 2, 9]");
    workspace.folder().write("other.yaml", sweep);
    check_bad_input(workspace.tool({"sweep", "other.yaml", "--out", "out"}),
                    {"out: holds the sweep sweep.yaml: 8 of its 24 points are not in other.yaml, the first is point 4 "
                     "(design=plain.yaml workload.samples.count=1 accelerator.architecture=faster "
                     "accelerator.fifos.fragment_depth.depth=8"});
    CHECK(workspace.text("out/results.csv") == before);
    require_done(workspace.tool({"sweep", "other.yaml", "--out", "other"}));
    check_bad_input(workspace.tool({"sweep", "merge", "out", "other", "--out", "merged"}),
                    {"other: holds another sweep than out"});
    CHECK_FALSE(workspace.has("merged"));
}

TEST_CASE("A sweep refuses bad input with one line, before anything is made", "[sweeps]") {
    SweepWorkspace const workspace;
    check_bad_input(workspace.sweep("out", {"--shard", "3/2"}), {"--shard 3/2: expected I/N"});
    check_bad_input(workspace.sweep("out", {"--shard", "two"}), {"--shard two: expected I/N"});
    check_bad_input(workspace.tool({"sweep", "none.yaml", "--out", "out"}), {"none.yaml: no such file"});
    check_bad_input(workspace.tool({"sweep", "sweep.yaml"}), {"--out DIR"});
    check_bad_input(workspace.tool({"sweep", "merge", "none", "--out", "out"}), {"none: no such folder"});
    workspace.folder().write("bad.yaml", SweepWorkspace::head() + "  - {key: workload.object, values: [none.obj]}\n");
    check_bad_input(workspace.tool({"sweep", "bad.yaml", "--out", "out"}),
                    {"bad.yaml: point 0 (workload.object=none.obj): ", "none.obj: no such file"});
    workspace.folder().write("bad.yaml", SweepWorkspace::head() + "  - {key: workload.object, values: [mug, mgu]}\n");
    check_bad_input(workspace.tool({"sweep", "bad.yaml", "--out", "out"}),
                    {"bad.yaml: point 1 (workload.object=mgu)", "did you mean mug?"});
    workspace.folder().write(
        "bad.yaml", SweepWorkspace::head() + "  - {key: accelerator.loops.rasterizer.scan.depth, values: [8, 4]}\n");
    check_bad_input(workspace.tool({"sweep", "bad.yaml", "--out", "out"}),
                    {"bad.yaml: point 1 (accelerator.loops.rasterizer.scan.depth=4)", "write_latency"});
    CHECK_FALSE(workspace.has("out"));
    std::filesystem::create_directory(workspace.folder() / "mine");
    workspace.folder().write("mine/notes.txt", "x");
    check_bad_input(workspace.sweep("mine"), {"mine: holds other files"});
}

TEST_CASE("A point that fails is named, and can be tried again", "[sweeps]") {
    SweepWorkspace const workspace;
    workspace.folder().write(
        "sweep.yaml",
        SweepWorkspace::head() + "  - {key: 'workload.pose.translation_m', values: [[0, 0, 0.65], [0, 0, 0.01]]}\n");
    CommandResult const result = workspace.sweep("out");
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.err,
               Contains("1 points failed, the first is point 1 (workload.pose.translation_m=[0, 0, 0.01])"));
    CHECK_THAT(workspace.text("out/results.csv"), Contains("1,\"[0, 0, 0.01]\",failed,,,,,,,,"));
    std::string const journal = workspace.text("out/journal");
    CHECK(workspace.sweep("out").exit_code == 1);
    CHECK(workspace.text("out/journal") == journal);
    CHECK_THAT(workspace.sweep("out", {"--retry-failed"}).out, Contains("1 of 2 points are done already"));
    CHECK(lines_of(workspace.text("out/journal")).size() == 2);
}

TEST_CASE("Event files can be kept, and one that is damaged is made anew", "[sweeps]") {
    SweepWorkspace const workspace;
    std::string const two = "  - {key: accelerator.raster_cores, values: [1, 2";
    workspace.folder().write("sweep.yaml", SweepWorkspace::head() + two + "]}\n");
    require_done(workspace.sweep("out", {"--keep-events"}));
    REQUIRE(entries_in(workspace.folder() / "out/events") == 1);
    std::filesystem::path const file = std::filesystem::directory_iterator(workspace.folder() / "out/events")->path();
    std::string bytes = content_of(file);
    bytes[bytes.size() / 3] = static_cast<char>(bytes[bytes.size() / 3] ^ 1);
    std::ofstream(file, std::ios::binary) << bytes;
    workspace.folder().write("sweep.yaml", SweepWorkspace::head() + two + ", 3]}\n");
    require_done(workspace.sweep("out"));
    require_done(workspace.sweep("fresh"));
    CHECK(workspace.text("out/results.csv") == workspace.text("fresh/results.csv"));
    CHECK_FALSE(workspace.has("out/events"));
}

TEST_CASE("Points of a trace are those of runs of it", "[sweeps]") {
    SweepWorkspace const workspace;
    require_done(workspace.tool({"record", "config.yaml", "--out", "trace", "--set", "accelerator.window=40"}));
    workspace.folder().write("sweep.yaml",
                             "format: faster-sweep\nversion: 1\nset: {workload.trace: trace, "
                             "accelerator.fifos.edge_token.depth: 4096}\ndimensions:\n"
                             "  - {key: accelerator.raster_cores, values: [1, 2]}\n");
    require_done(workspace.sweep("out"));
    std::vector<Row> const rows = rows_of(workspace.text("out/results.csv"));
    for (std::size_t i = 0; i < 2; ++i) {
        require_done(workspace.tool({"run", "config.yaml", "--trace", "trace", "--out", "run", "--set",
                                     "accelerator.raster_cores=" + std::to_string(i + 1), "--set",
                                     "accelerator.fifos.edge_token.depth=4096"}));
        Json const run = workspace.summary("run");
        CHECK(rows[i].at("total_cycles") == run["total_cycles"].dump());
        CHECK(std::stod(rows[i].at("ramb36")) == run["resources"]["cores"]["ramb36"].get<double>());
    }
}

TEST_CASE("A point that is ended before it has begun is a failed one, and no interruption", "[sweeps]") {
    SweepWorkspace const workspace;
    for (int i = 0; i < 3; ++i) {
        CommandResult const result = workspace.sweep("out" + std::to_string(i), {"-j1", "--time-limit", "0.001"});
        CHECK(result.exit_code == 1);
        CHECK_THAT(result.err, Contains("failed") && !Contains("interrupted"));
    }
}

TEST_CASE("The page of a sweep holds the table's figures", "[sweeps]") {
    SweepWorkspace const workspace;
    require_done(workspace.sweep("out"));
    Json const data = json_element(workspace.text("out/index.html"), "data");
    CHECK_THAT(workspace.text("out/index.html"),
               Contains("<code>faster-sim sweep sweep.yaml</code>") && Contains("fnv1a64:"));
    std::vector<Row> const rows = rows_of(workspace.text("out/results.csv"));
    REQUIRE(data["points"].size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(data["points"][i]["status"] == rows[i].at("status"));
        CHECK(data["points"][i]["values"][0] == rows[i].at("design"));
        if (rows[i].at("status") == "done")
            CHECK(data["points"][i]["total_cycles"].dump() == rows[i].at("total_cycles"));
    }
}

TEST_CASE("A sweep shows on a terminal how long it will take", "[sweeps]") {
    SweepWorkspace const workspace;
    std::string const path = workspace.folder().path().string();
    std::string sweep = workspace.text("sweep.yaml");
    workspace.folder().write("sweep.yaml", sweep + "  - {seeds: [workload.samples.seed], count: 4}\n");
    std::string const shown =
        output_on_terminal(FASTER_SIM_BINARY, {"sweep", path + "/sweep.yaml", "--out", path + "/out", "-j", "2"}, {});
    CHECK_THAT(shown, Contains("/96 points, ") && Contains(" s left"));
}

}  // namespace sweep_test
