#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace double_buffers_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

Words with_buffers(Words words) {
    words.insert(words.end(),
                 {"--set", "accelerator.edge_map.buffers=2", "--set", "accelerator.inlier_unit.buffers=2"});
    return words;
}

/// The cells of a column in the rows of core 0.
Words column(std::string const& csv, std::size_t number) {
    Words cells;
    for (std::string const& line : lines_of(csv)) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < number; ++i)
            begin = line.find(',', begin) + 1;
        if (line.rfind("0,", 0) == 0)
            cells.push_back(line.substr(begin, line.find(',', begin) - begin));
    }
    return cells;
}

bool has_row(nlohmann::ordered_json const& rows, char const* key, std::string const& value) {
    return std::any_of(rows.begin(), rows.end(), [&](auto const& row) { return row[key] == value; });
}

TEST_CASE("Two buffers of each bring two modules and four FIFOs, and take the loops along", "[double_buffers]") {
    SmallWorkspace const workspace;
    CommandResult const result = workspace.run(with_buffers(
        {"--out", "out", "--vcd", "w.vcd", "--vcd-samples", "0", "--timeline", "t.json", "--report", "r.html"}));
    require_done(result);
    CHECK_THAT(result.out, Contains("inlier_sweep.sweep") && Contains("edge_map_output.output"));
    CHECK_THAT(result.out, !Contains("inlier_unit.sweep") && !Contains("edge_map_builder.output"));
    CHECK(column(workspace.text("out/fifos.csv"), 1).size() == 18);
    CHECK(column(workspace.text("out/fifos.csv"), 1).back() == "depth_free");
    CHECK(column(workspace.text("out/loops.csv"), 1) == Words{"rasterizer", "edge_map_builder", "edge_map_builder",
                                                              "inlier_unit", "inlier_unit", "edge_map_output",
                                                              "inlier_sweep"});
    auto const summary = workspace.summary("out");
    CHECK(has_row(summary["modules"], "module", "edge_map_output"));
    CHECK(has_row(summary["modules"], "module", "inlier_sweep"));
    CHECK(summary["brams"][0]["buffers"] == 2);
    CHECK(summary["brams"][2]["ramb36"] == 4);  // 3,600 x 11: 4K x 9 twice, twice
    CHECK_THAT(workspace.text("w.vcd"), Contains("buffer1_port0_address") && Contains("fifo_map_full"));
    CHECK_THAT(workspace.text("w.stalls.txt"), Contains("depth_full empty"));
    CHECK_THAT(workspace.text("t.json"), Contains("inlier_sweep"));
}

TEST_CASE("With one buffer nobody hears of a second", "[double_buffers]") {
    SmallWorkspace const workspace;
    CommandResult const result = workspace.run({"--out", "out", "--vcd", "w.vcd", "--vcd-samples", "0"});
    require_done(result);
    for (std::string const& text : {result.out, workspace.text("out/fifos.csv"), workspace.text("out/loops.csv"),
                                    workspace.text("w.vcd"), workspace.text("w.stalls.txt")})
        CHECK_THAT(text, !Contains("map_full") && !Contains("inlier_sweep") && !Contains("buffer0"));
}

TEST_CASE("Both engines write the same files with two buffers, and the counters of one", "[double_buffers]") {
    SmallWorkspace const workspace;
    require_done(workspace.run(with_buffers({"--out", "a", "--timeline", "a.json"})));
    require_done(
        workspace.run(with_buffers({"--out", "b", "--timeline", "b.json", "--set", "simulation.engine=lockstep"})));
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"})
        CHECK(workspace.text("a" + file) == workspace.text("b" + file));
    CHECK(workspace.text("a.json") == workspace.text("b.json"));
    require_done(workspace.run({"--out", "one"}));
    for (std::size_t counter = 5; counter < 10; ++counter)
        CHECK(column(workspace.text("a/samples.csv"), counter) == column(workspace.text("one/samples.csv"), counter));
}

TEST_CASE("Two buffers of which the touched region is read out run end to end", "[double_buffers][sweep_region]") {
    SmallWorkspace const workspace;
    Words const touched{"--set", "accelerator.inlier_unit.sweep_region=touched"};
    auto const run = [&](Words words) {
        words.insert(words.end(), touched.begin(), touched.end());
        require_done(workspace.run(with_buffers(words)));
    };
    run({"--out", "a", "--vcd", "w.vcd", "--vcd-samples", "1", "--timeline", "a.json", "--report", "r.html",
         "--critical-path", "--sensitivities", "--events", "events"});
    run({"--out", "b", "--timeline", "b.json", "--set", "simulation.engine=lockstep"});
    CHECK(workspace.text("a.json") == workspace.text("b.json"));
    require_done(run_command(FASTER_SIM_BINARY, {"whatif", "events", "--out", "c"}, workspace.folder().path()));
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"}) {
        CHECK(workspace.text("a" + file) == workspace.text("b" + file));
        CHECK(workspace.text("a" + file) == workspace.text("c" + file));
    }
    CHECK(column(workspace.text("a/fifos.csv"), 1).size() == 20);
    CHECK_THAT(workspace.text("w.vcd"), Contains("read_last_row"));
    require_done(run_command(FASTER_SIM_BINARY, {"size-fifos", "events", "--within", "5", "--out", "sized"},
                             workspace.folder().path()));
    require_done(workspace.run({"--out", "one"}));
    for (std::size_t counter = 5; counter < 10; ++counter)
        CHECK(column(workspace.text("a/samples.csv"), counter) == column(workspace.text("one/samples.csv"), counter));
}

TEST_CASE("A run with two buffers is recorded, and retimed with keys that loops keep", "[double_buffers][events]") {
    SmallWorkspace const workspace;
    require_done(workspace.run(with_buffers({"--events", "events", "--sensitivities", "--out", "run"})));
    CHECK_THAT(workspace.text("run/sensitivities.csv"),
               Contains("accelerator.fifos.map_free.depth") && Contains("accelerator.loops.inlier_unit.sweep.ii"));
    Words const change{"--set", "accelerator.loops.inlier_unit.sweep.ii=5", "--set",
                       "accelerator.loops.edge_map_builder.output.depth=9"};
    Words words{"--out", "changed"};
    words.insert(words.end(), change.begin(), change.end());
    require_done(workspace.run(with_buffers(words)));
    words = {"whatif", "events", "--out", "retimed"};
    words.insert(words.end(), change.begin(), change.end());
    require_done(run_command(FASTER_SIM_BINARY, words, workspace.folder().path()));
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"})
        CHECK(workspace.text("retimed" + file) == workspace.text("changed" + file));
    check_bad_input(run_command(FASTER_SIM_BINARY, {"whatif", "events", "--set", "accelerator.inlier_unit.buffers=1"},
                                workspace.folder().path()),
                    {"accelerator.inlier_unit.buffers"});
}

}  // namespace double_buffers_test
