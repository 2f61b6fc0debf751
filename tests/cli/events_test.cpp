#include <algorithm>
#include <catch2/catch.hpp>

#include "dataflow/base/grouped_digits.hpp"
#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/report_page.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace events_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// A configuration, and the event file of its run.
class Workspace {
  public:
    Workspace() { require_done(tool({"run", "config.yaml", "--events", "events"})); }

    CommandResult tool(Words const& words) const { return run_command(FASTER_SIM_BINARY, words, folder().path()); }
    CommandResult whatif(Words words) const {
        words.insert(words.begin(), {"whatif", "events"});
        return tool(words);
    }
    std::string text(std::string const& name) const { return small_.text(name); }
    Json summary(std::string const& run) const {
        Json json = small_.summary(run);
        json.erase("host");
        json.erase("made_by");
        return json;
    }
    bool has(std::string const& name) const { return std::filesystem::exists(folder() / name); }
    TempFolder const& folder() const { return small_.folder(); }

  private:
    SmallWorkspace small_;
};

TEST_CASE("whatif writes what a run with the same keys writes") {
    Workspace const workspace;
    Words const settings{"--set", "accelerator.fifos.edge_token.depth=16",
                         "--set", "accelerator.fifos.command.kind=memory",
                         "--set", "accelerator.brams.depth_buffer.ports=3",
                         "--set", "accelerator.brams.edge_map.partition.type=cyclic",
                         "--set", "accelerator.brams.edge_map.partition.factor=2",
                         "--set", "accelerator.raster_cores=3",
                         "--set", "accelerator.clock_mhz=150"};
    Words run{"run", "config.yaml", "--out", "run"};
    Words whatif{"--out", "whatif"};
    for (Words* words : {&run, &whatif})
        words->insert(words->end(), settings.begin(), settings.end());
    require_done(workspace.tool(run));
    CommandResult const result = workspace.whatif(whatif);
    require_done(result);
    CHECK_THAT(result.out, StartsWith("A  events (") && Contains("\nTotal\n") && !Contains("lane-cycles went"));
    CHECK_THAT(result.out, Contains("accelerator.raster_cores: 2 -> 3"));
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"})
        CHECK(workspace.text("run" + file) == workspace.text("whatif" + file));
    CHECK(workspace.summary("run") == workspace.summary("whatif"));
}

TEST_CASE("whatif without changes finds the recorded run") {
    Workspace const workspace;
    CommandResult const result = workspace.whatif({});
    require_done(result);
    CHECK_THAT(result.out, Contains("identical: configuration, results and cycles of events and whatif"));
}

TEST_CASE("whatif keeps the counters of hidden pixels, where they were recorded") {
    Workspace const workspace;
    Words const hidden{"--set", "accelerator.inlier_unit.hidden=counted"};
    Words run{"run", "config.yaml", "--events", "hidden", "--out", "run"};
    run.insert(run.end(), hidden.begin(), hidden.end());
    require_done(workspace.tool(run));
    require_done(workspace.tool({"whatif", "hidden", "--out", "whatif"}));
    CHECK_THAT(workspace.text("run/samples.csv"), Contains("edge_inlier,hidden,visible_top,"));
    CHECK(workspace.text("run/samples.csv") == workspace.text("whatif/samples.csv"));
    CommandResult const refused = workspace.whatif(hidden);
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("accelerator.inlier_unit.hidden") && Contains("decides what is counted"));
}

TEST_CASE("whatif answers first, and has the report behind --full") {
    Workspace const workspace;
    Words const setting{"--set", "accelerator.brams.depth_buffer.ports=3"};
    CommandResult const brief = workspace.whatif(setting);
    require_done(brief);
    CommandResult const full = workspace.whatif({"--full", setting[0], setting[1]});
    require_done(full);
    CHECK_THAT(full.out, StartsWith(brief.out) && Contains("lane-cycles went"));
    std::vector<std::string> const lines = lines_of(brief.out);
    CHECK(std::find(lines.begin(), lines.end(), "Total") < lines.begin() + 5);
    CHECK(lines.size() < 60);
}

TEST_CASE("whatif refuses keys that decide about more than time, by name") {
    Workspace const workspace;
    auto const check = [&](std::string const& setting, std::string const& why) {
        check_bad_input(workspace.whatif({"--set", setting, "--out", "out"}),
                        {"--set " + setting, why, "use faster-sim run"});
        CHECK_FALSE(workspace.has("out"));
    };
    check("accelerator.window=50", "accelerator.window decides what is computed");
    check("accelerator.fraction_bits.vertex_z=13", "accelerator.fraction_bits.vertex_z decides what is computed");
    check("accelerator.rasterizer.setup_overlap=1",
          "accelerator.rasterizer.setup_overlap decides which operations there are");
    check("accelerator.rasterizer.scan=spans", "accelerator.rasterizer.scan decides which operations there are");
    check("accelerator.inlier_unit.fragment_loop=flattened",
          "accelerator.inlier_unit.fragment_loop decides which operations there are");
    check("accelerator.rasterizer.lanes=2", "accelerator.rasterizer.lanes decides which operations there are");
    check("accelerator.edge_map.flush_last=true", "accelerator.edge_map.flush_last decides what is computed");
    check("accelerator.inlier_unit.sweep_lanes=2", "accelerator.inlier_unit.sweep_lanes decides which operations");
    check("workload.samples.count=4", "workload.samples.count is part of the workload");
    check("simulation.engine=lockstep", "simulation.engine decides how a run is simulated");
    check_bad_input(workspace.whatif({"--set", "accelerator.fifos.edge_tokn.depth=3"}), {"edge_token"});
    check_bad_input(workspace.whatif({"--set", "accelerator.loops.rasterizer.scan.depth=4"}), {"write_latency"});
}

TEST_CASE("whatif reports a deadlock as a run does") {
    Workspace const workspace;
    Words const setting{"--set", "accelerator.fifos.fragment_depth.depth=1"};
    CommandResult const run = workspace.tool({"run", "config.yaml", "--out", "out", setting[0], setting[1]});
    auto const summary = workspace.summary("out");
    CommandResult const whatif = workspace.whatif({"--out", "out", setting[0], setting[1]});
    CHECK(whatif.exit_code == 3);
    CHECK(whatif.err == run.err);
    CHECK(workspace.summary("out") == summary);
}

TEST_CASE("What was done until a deadlock is the same in both engines, and in a what-if") {
    SmallWorkspace const workspace;
    for (std::string const depth : {"fragment_depth.depth=1", "fragment_index.depth=1"}) {
        CAPTURE(depth);
        Words const stuck{"--set", "accelerator.fifos." + depth, "--set", "accelerator.raster_cores=1"};
        for (std::string const engine : {"lockstep", "decoupled"}) {
            Words words{"--set", "simulation.engine=" + engine, "--out", engine};
            words.insert(words.end(), stuck.begin(), stuck.end());
            CHECK(workspace.run(words).exit_code == 3);
        }
        require_done(workspace.run({"--events", "events"}));
        Words words{"whatif", "events", "--out", "retimed"};
        words.insert(words.end(), stuck.begin(), stuck.end());
        CHECK(run_command(FASTER_SIM_BINARY, words, workspace.folder().path()).exit_code == 3);
        Json const partial = workspace.summary("lockstep")["partial"];
        CHECK(!partial["fifos"].empty());
        CHECK(partial == workspace.summary("decoupled")["partial"]);
        CHECK(partial == workspace.summary("retimed")["partial"]);
    }
}

TEST_CASE("A run that deadlocks writes no event file") {
    Workspace const workspace;
    CommandResult const result = workspace.tool(
        {"run", "config.yaml", "--events", "stuck", "--set", "accelerator.fifos.fragment_depth.depth=1"});
    CHECK(result.exit_code == 3);
    CHECK_FALSE(workspace.has("stuck"));
}

TEST_CASE("whatif takes a matrix of configurations") {
    Workspace const workspace;
    workspace.folder().write("matrix.yaml",
                             "- {accelerator.raster_cores: 3}\n"
                             "- accelerator.fifos.fragment_depth.depth: 1\n"
                             "- accelerator.brams.depth_buffer.ports: 3\n"
                             "  accelerator.clock_mhz: 100\n"
                             "- {}\n");
    CommandResult const result = workspace.whatif({"--matrix", "matrix.yaml", "--csv", "rows.csv"});
    require_done(result);
    std::vector<std::string> const rows = lines_of(workspace.text("rows.csv"));
    REQUIRE(rows.size() == 5);
    CHECK(rows[0] == "row,configuration,outcome,total_cycles,milliseconds,change_cycles");
    CHECK(rows[2] == "1,accelerator.fifos.fragment_depth.depth=1,deadlock,,,");
    CHECK_THAT(rows[3], Contains("accelerator.brams.depth_buffer.ports=3 accelerator.clock_mhz=100,finished,"));
    CHECK(rows[4].substr(rows[4].rfind(',')) == ",0");
    require_done(workspace.tool({"run", "config.yaml", "--out", "run", "--set", "accelerator.raster_cores=3"}));
    std::string const cycles = std::to_string(workspace.summary("run")["total_cycles"].get<std::uint64_t>());
    CHECK_THAT(rows[1], Contains("finished," + cycles + ","));
    CHECK_THAT(result.out, Contains(dataflow::grouped(std::stoull(cycles))));
}

TEST_CASE("whatif compares a matrix with the recorded total, load included") {
    Workspace const workspace;
    require_done(workspace.tool({"run", "config.yaml", "--events", "loads", "--set", "accelerator.memory.model=axi",
                                 "--set", "accelerator.memory.mesh=on_chip"}));
    workspace.folder().write("matrix.yaml", "- {}\n");
    require_done(workspace.tool({"whatif", "loads", "--matrix", "matrix.yaml", "--csv", "rows.csv"}));
    std::string const row = lines_of(workspace.text("rows.csv")).at(1);
    CHECK(row.substr(row.rfind(',')) == ",0");
}

TEST_CASE("whatif refuses to count the words of other banks where they are cleared side by side") {
    Workspace const workspace;
    Words const wide{"--set", "accelerator.inlier_unit.clearing=wide"};
    Words record{"run", "config.yaml", "--events", "wide.events"};
    record.insert(record.end(), wide.begin(), wide.end());
    require_done(workspace.tool(record));
    std::string const type = "accelerator.brams.depth_buffer.partition.type=cyclic";
    std::string const factor = "accelerator.brams.depth_buffer.partition.factor=2";
    check_bad_input(workspace.tool({"whatif", "wide.events", "--set", type, "--set", factor}),
                    {"--set " + type, "decides how many iterations a wide clearing loop has", "use faster-sim run"});
    require_done(workspace.tool({"whatif", "wide.events", "--set", "accelerator.brams.edge_map.partition.type=cyclic",
                                 "--set", "accelerator.brams.edge_map.partition.factor=2"}));
}

TEST_CASE("A bad matrix is refused with its line") {
    Workspace const workspace;
    auto const check = [&](std::string const& text, std::vector<std::string> const& parts) {
        workspace.folder().write("matrix.yaml", text);
        check_bad_input(workspace.whatif({"--matrix", "matrix.yaml", "--csv", "rows.csv"}), parts);
        CHECK_FALSE(workspace.has("rows.csv"));
    };
    check("accelerator.raster_cores: 3\n", {"matrix.yaml:1", "expected a list"});
    check("- {accelerator.raster_cores: 3}\n- 5\n", {"matrix.yaml:2", "expected a map"});
    check("- {}\n- {accelerator.window: 3}\n", {"matrix.yaml:2", "accelerator.window"});
    check("- {}\n- {accelerator.raster_cores: many}\n", {"matrix.yaml:2", "expected an integer"});
    check("- {accelerator.raster_cores: [3]}\n", {"matrix.yaml:1", "expected one value"});
    workspace.folder().write("matrix.yaml", "{}\n");
    std::string const refused = workspace.whatif({"--matrix", "matrix.yaml"}).err;
    std::string const such_as = "such as ";
    REQUIRE_THAT(refused, Contains(such_as));
    workspace.folder().write("matrix.yaml", refused.substr(refused.find(such_as) + such_as.size()));
    require_done(workspace.whatif({"--matrix", "matrix.yaml"}));
}

TEST_CASE("What is no event file is refused with one line") {
    Workspace const workspace;
    std::string const bytes = workspace.text("events");
    auto const check = [&](std::string const& content, std::string const& what) {
        workspace.folder().write("bad", content);
        check_bad_input(workspace.tool({"whatif", "bad"}), {"bad: ", what});
        check_bad_input(workspace.tool({"sensitivities", "bad"}), {"bad: ", what});
    };
    check("accelerator: {}\n", "is no event file");
    check("", "is no event file");
    check(bytes.substr(0, bytes.size() / 2), "is cut off");
    check(bytes.substr(0, 8) + '\1' + bytes.substr(9), "of version 1, expected version 5");
    std::string damaged = bytes;
    char& middle = damaged[bytes.size() / 2];
    middle = static_cast<char>(middle ^ 0xFF);  // all of it: zstd ignores a bit of each frame
    check(damaged, "damaged");
    check_bad_input(workspace.tool({"whatif", "none"}), {"none: no such file"});
    check_bad_input(workspace.tool({"run", "config.yaml", "--events", "none/."}), {"none"});
}

TEST_CASE("sensitivities of an event file are those of the run, with slack") {
    Workspace const workspace;
    require_done(workspace.tool({"run", "config.yaml", "--sensitivities", "--out", "run"}));
    CommandResult const result = workspace.tool({"sensitivities", "events", "--csv", "s.csv", "--json", "s.json"});
    require_done(result);
    CHECK_THAT(result.out, Contains("Slack: how far one key alone may go without costing a cycle, if more of a change "
                                    "never costs less\n"));
    std::vector<std::string> const rows = lines_of(workspace.text("s.csv"));
    std::vector<std::string> const of_run = lines_of(workspace.text("run/sensitivities.csv"));
    REQUIRE(rows.size() == of_run.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        CHECK(rows[i].rfind(of_run[i] + ",", 0) == 0);
    CHECK(rows[0] == of_run[0] + ",slack,slack_end");
    Json const json = Json::parse(workspace.text("s.json"));
    CHECK(json["total_cycles"] == workspace.summary("run")["total_cycles"]);
    CHECK(2 * json["sensitivities"].size() + 1 == rows.size());
    CHECK(json["sensitivities"][0]["up"].contains("slack"));
}

}  // namespace events_test
