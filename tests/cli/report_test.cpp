#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/report_page.hpp"
#include "support/small_workspace.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"
#include "support/unpacked_timeline.hpp"

namespace report_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

using Workspace = SmallWorkspace;

void check_refused(Workspace const& workspace, Words const& arguments, std::string const& part) {
    std::size_t const before = entries_in(workspace.folder().path());
    CommandResult const result = workspace.run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(lines_of(result.err).size() == 1);
    CHECK_THAT(result.err, Contains(part));
    CHECK(entries_in(workspace.folder().path()) == before);
}

/// The text without what stands from `begin` on, up to `end`.
std::string without(std::string text, std::string const& begin, std::string const& end) {
    std::size_t const first = text.find(begin);
    REQUIRE(first != std::string::npos);
    return text.erase(first, text.find(end, first) - first);
}

/// The page without the value of simulation.engine, and the command that gave it.
std::string without_engine(std::string const& page) {
    return without(without(page, R"({"key":"simulation.engine","value":")", "}"), "<code>faster-sim run", "</code>");
}

TEST_CASE("A run writes its HTML report without --out, and nothing else") {
    Workspace const workspace;
    CommandResult const result = workspace.run({"--report", "new/report.html"});
    require_done(result);
    CHECK_THAT(result.out, Contains("written: new/report.html"));
    CHECK(entries_in(workspace.folder().path()) == 2);
    CHECK(entries_in(workspace.folder() / "new") == 1);
    Json const data = json_element(workspace.text("new/report.html"), "data");
    CHECK(data["headline"]["samples"] == 3);
    CHECK(data["pictures"].empty());
    CHECK_THAT(workspace.text("new/report.html"), Contains("<h1>config.yaml</h1>"));
}

TEST_CASE("The HTML report may lie in the folder of the results, new or old") {
    Workspace const workspace;
    for (int run = 0; run < 2; ++run) {
        require_done(workspace.run({"--out", "out", "--report", "out/report.html"}));
        CHECK(entries_in(workspace.folder() / "out") == 7);
        CHECK(entries_in(workspace.folder().path()) == 2);
    }
}

/// A run with a `dot` that is this script, or none.
CommandResult run_with_dot(Workspace const& workspace, std::string const& script) {
    fs::create_directory(workspace.folder() / "bin");
    if (!script.empty()) {
        workspace.folder().write("bin/dot", "#!/bin/sh\n" + script + "\n");
        fs::permissions(workspace.folder() / "bin/dot", fs::perms::owner_all);
    }
    return run_command("/usr/bin/env",
                       {"PATH=" + (workspace.folder() / "bin").string(), FASTER_SIM_BINARY, "run", "config.yaml",
                        "--report", "report.html"},
                       workspace.folder().path());
}

TEST_CASE("A Graphviz that fails fails the report in one line, and without any the page has no graph") {
    Workspace const workspace;
    require_done(run_with_dot(workspace, ""));
    std::string const page = workspace.text("report.html");
    CHECK(json_element(page, "data")["graph"]["wide"].is_null());
    auto const [script, message] = GENERATE(table<std::string, std::string>(
        {{"exit 3", "dot: failed (exit code 3), expected a program that works"},
         {"kill -9 $$", "dot: was killed, expected a program that works"},
         {"exit 0", "dot: wrote nothing of the graph, expected a Graphviz that works"},
         {R"(echo '{"bb": "0,0,1,1", "objects": [{"pos": ')",
          "dot: wrote no more than a part of the graph, expected a Graphviz that works"},
         {R"(echo '{"bb": "0,0,1,1", "objects": []}')",
          "dot: wrote no more than a part of the graph, expected a Graphviz that works"}}));
    CAPTURE(script);
    check_bad_input(run_with_dot(workspace, script), {message});
    CHECK(workspace.text("report.html") == page);
    CHECK(entries_in(workspace.folder().path()) == 3);  // with bin
}

/// A run whose sources can be looked at there.
CommandResult run_with_source_link(Workspace const& workspace, std::string const& link) {
    return run_command(
        "/usr/bin/env",
        {"FASTER_SOURCE_LINK=" + link, FASTER_SIM_BINARY, "run", "config.yaml", "--report", "report.html"},
        workspace.folder().path());
}

TEST_CASE("The graph of a report knows the lines that describe the modules, and where they can be looked at") {
    Workspace const workspace;
    require_done(run_with_source_link(workspace, "https://example.org/blob/main/{file}#L{line}"));
    Json const source = json_element(workspace.text("report.html"), "data")["graph"]["sources"]["rasterizer"];
    std::string const file = "src/modules/rasterizer/rasterizer.cpp";
    CHECK(source["file"] == file);
    std::string const line = std::to_string(source["line"].get<int>());
    CHECK(source["link"] == "https://example.org/blob/main/" + file + "#L" + line);
    CHECK_THAT(lines_of(content_of(fs::path(FASTER_SOURCE_DIR) / file)).at(std::stoul(line) - 1),
               Contains("ModuleDescription"));
}

TEST_CASE("An address that is none of a source line is refused in one line") {
    Workspace const workspace;
    auto const link = GENERATE(as<std::string>(), "javascript:alert({file})", "https://example.org/", "{file}");
    check_bad_input(run_with_source_link(workspace, link), {"FASTER_SOURCE_LINK: '" + link + "'"});
    CHECK(entries_in(workspace.folder().path()) == 1);
}

TEST_CASE("The HTML report and summary.json agree") {
    Workspace const workspace;
    require_done(workspace.run({"--out", "out", "--report", "report.html"}));
    Json const data = json_element(workspace.text("report.html"), "data");
    Json const summary = Json::parse(workspace.text("out/summary.json"));
    CHECK(data["headline"]["total_cycles"] == summary["total_cycles"]);
    for (char const* const table : {"fifos", "loops", "bound_by"})
        CHECK(data[table] == summary[table]);
    CHECK(data["configuration"].size() == summary["configuration"].size());
}

TEST_CASE("Equal runs write the same HTML report, on either engine") {
    Workspace const workspace;
    auto const report_of = [&](std::string const& engine, std::string const& name) {
        require_done(workspace.run({"--images", "2", "--set", "simulation.engine=" + engine, "--report", name}));
        return workspace.text(name);
    };
    std::string const page = report_of("decoupled", "first.html");
    CHECK((page == report_of("decoupled", "second.html")));
    CHECK((without_engine(page) == without_engine(report_of("lockstep", "third.html"))));
}

TEST_CASE("Results and page say what made them, whatever the names of outputs") {
    Workspace const workspace;
    require_done(
        workspace.run({"--out", "o", "--critical-path", "--set", "workload.samples.seed=3", "--report", "r.html"}));
    Json const made_by = workspace.summary("o")["made_by"];
    CHECK(made_by["program"] == "faster-sim");
    CHECK(made_by["command"] == "faster-sim run config.yaml --critical-path --set workload.samples.seed=3");
    std::string const version = run_command(FASTER_SIM_BINARY, {"--version"}, "/").out;
    CHECK(version.rfind(made_by["version"].get<std::string>(), 0) == 0);
    if (!made_by["commit"].is_null())
        CHECK_THAT(version, Contains("(commit " + made_by["commit"].get<std::string>() + " of " +
                                     made_by["commit_date"].get<std::string>() + ")"));
    std::string const page = workspace.text("r.html");
    for (char const* const part : {"version", "command", "configuration"})
        CHECK_THAT(page, Contains(made_by[part].get<std::string>()));
    CHECK(workspace.summary("o").rbegin().key() == "made_by");

    // The hash tells configurations apart, however they were given, and does not look at the engine.
    require_done(
        workspace.run({"--set", "simulation.engine=lockstep", "--set", "workload.samples.seed=3", "--out", "p"}));
    CHECK(workspace.summary("p")["made_by"]["configuration"] == made_by["configuration"]);
    require_done(workspace.run({"--out", "q"}));
    CHECK(workspace.summary("q")["made_by"]["configuration"] != made_by["configuration"]);
    CHECK(workspace.summary("q")["made_by"]["command"] == "faster-sim run config.yaml");
}

TEST_CASE("The command in a result can be typed again") {
    Workspace const workspace;
    workspace.folder().write("it's & mine.yaml", workspace.text("config.yaml"));
    CommandResult const result = run_command(
        FASTER_SIM_BINARY, {"run", "it's & mine.yaml", "--out", "o", "--report", "r.html"}, workspace.folder().path());
    require_done(result);
    std::string const command = workspace.summary("o")["made_by"]["command"];
    CHECK(command == R"(faster-sim run 'it'\''s & mine.yaml')");
    CHECK_THAT(workspace.text("r.html"), Contains("it&#39;\\&#39;&#39;s &amp; mine.yaml"));
    std::string const bin = fs::path(FASTER_SIM_BINARY).parent_path().string();
    CommandResult const again =
        run_command("/bin/sh", {"-c", "PATH=" + bin + ":$PATH; " + command}, workspace.folder().path());
    require_done(again);
    CHECK_THAT(again.out, Contains(lines_of(result.out)[1]));  // the total
}

TEST_CASE("Pictures go into the HTML report, with and without --out") {
    Workspace const workspace;
    require_done(workspace.run({"--images", "2", "--report", "alone.html"}));
    require_done(workspace.run({"--images", "2", "--report", "both.html", "--out", "out"}));
    CHECK((workspace.text("alone.html") == workspace.text("both.html")));
    Json const pictures = json_element(workspace.text("alone.html"), "data")["pictures"];
    REQUIRE(pictures.size() == 2);
    CHECK(pictures[1]["title"].get<std::string>().rfind("Sample 1", 0) == 0);
    CHECK(pictures[1]["png"].get<std::string>().rfind("iVBORw0KGgo", 0) == 0);  // a PNG's first bytes
}

TEST_CASE("A page that cannot be written is refused in one line before the run") {
    Workspace const workspace;
    check_refused(workspace, {"--report", "config.yaml/report.html"}, "config.yaml/report.html: cannot be written");
    check_refused(workspace, {"--report", "."}, "is a folder");
    check_refused(workspace, {"--report", "/dev/null", "--out", "new/out"}, "/dev/null: is no regular file");
    check_refused(workspace, {"--images", "2"}, "expected --out DIR or --report FILE");
}

TEST_CASE("A deadlock's page says who waits for whom, what the FIFOs hold, and what frees it") {
    Workspace const workspace;
    std::string const key = "accelerator.fifos.fragment_depth.depth";
    CommandResult const result = workspace.run({"--set", key + "=1", "--report", "report.html", "--out", "out"});
    CHECK(result.exit_code == 3);
    CHECK_THAT(result.err, Contains("written: report.html"));
    Json const data = json_element(workspace.text("report.html"), "data");
    Json const& deadlock = data["deadlock"];
    Json const expected = Json::parse(workspace.text("out/summary.json"))["deadlock"];
    for (auto const& [name, value] : expected.items())
        CHECK(deadlock[name] == value);
    CHECK(deadlock["deeper"] == Json::array({{{"fifo", "fragment_depth"}, {"key", key}, {"depth", 1}}}));
    CHECK(data["headline"]["samples"] == 3);
    CHECK(data["headline"]["samples_done"] == 0);
    for (Json const& wait : deadlock["stuck"])
        for (Json const& fifo : data["fifos"])
            if (fifo["core"] == wait["core"] && fifo["fifo"] == wait["fifo"]) {
                CHECK(fifo["occupancy"] == wait["occupancy"]);
                CHECK(fifo["capacity"] == wait["capacity"]);
                CHECK(fifo[wait["to"] == "write" ? "writer" : "reader"] == wait["process"]);
            }
    CHECK(data["command"] == "faster-sim run config.yaml");
    CHECK(data["settings"] == Json::array({key + "=1"}));
    require_done(workspace.run({"--set", key + "=4096"}));  // as the page tells to
}

using Cycles = std::uint64_t;

/// The bars of the finest level: [module, kind, item] from begin to end.
std::map<Json, std::vector<std::pair<Cycles, Cycles>>> bars_of(Json const& timeline) {
    Json const content = unpacked(timeline["packed"]);
    Json const& finest = content["levels"].back();
    std::map<Json, std::vector<std::pair<Cycles, Cycles>>> bars;
    auto begin = timeline["begin"].get<Cycles>();
    for (std::size_t i = 0; i < finest["item"].size(); ++i) {
        begin += finest["begin"][i].get<Cycles>();
        bars[content["items"][finest["item"][i].get<std::size_t>()]].emplace_back(
            begin, begin + finest["length"][i].get<Cycles>());
    }
    return bars;
}

TEST_CASE("A deadlock's page shows the samples that got stuck up to there, and the waits that never end") {
    Workspace const workspace;
    auto const page_of = [&](Words words, std::string const& name) {
        words.insert(words.end(), {"--set", "accelerator.fifos.fragment_depth.depth=1", "--report", name});
        CHECK(workspace.run(words).exit_code == 3);
        return json_element(workspace.text(name), "data");
    };
    auto const external = GENERATE(Words{}, Words{"--set", "accelerator.memory.model=axi"});
    Json const data = page_of(external, "report.html");
    Json const& timelines = data["timelines"];
    REQUIRE(timelines.size() == 2);  // of either core the first sample
    for (Json const& timeline : timelines) {
        CHECK(timeline["sample"] == (timeline["core"] == 0 ? 0 : 2));
        CHECK(timeline["end"].get<Cycles>() == data["deadlock"]["cycle"].get<Cycles>() + 1);
        auto const bars = bars_of(timeline);
        CHECK(bars.count(Json{"inlier_unit", "loop", "clear"}) == 1);
        CHECK(bars.count(Json{"vertex_transform", "loop", "vertex"}) == 1);
        for (Json const& wait : data["deadlock"]["stuck"])
            if (wait["core"] == timeline["core"]) {
                auto const found = bars.find(
                    Json{wait["process"], wait["to"] == "write" ? "full_stall" : "empty_stall", wait["fifo"]});
                CAPTURE(wait.dump());
                REQUIRE(found != bars.end());
                CHECK(found->second.back().first <=
                      std::max(wait["since_cycle"].get<Cycles>(), timeline["begin"].get<Cycles>()));
                CHECK(found->second.back().second == timeline["end"]);
            }
    }
    Words lockstep = external;
    lockstep.insert(lockstep.end(), {"--set", "simulation.engine=lockstep"});
    CHECK(page_of(lockstep, "lockstep.html")["timelines"] == timelines);
}

TEST_CASE("The page shows the samples that are asked for besides those that stand for others") {
    Workspace const workspace;
    auto const samples_with = [&](Words const& options) {
        Words words{"--report", "report.html"};
        words.insert(words.end(), options.begin(), options.end());
        require_done(workspace.run(words));
        Json const data = json_element(workspace.text("report.html"), "data");
        std::set<std::size_t> samples;
        for (Json const& timeline : data["timelines"])
            samples.insert(timeline["sample"].get<std::size_t>());
        return samples;
    };
    CHECK(samples_with({"--set", "workload.samples.count=7"}).size() == 3);
    CHECK(samples_with({"--set", "workload.samples.count=7", "--report-samples", "all"}).size() == 7);
    auto const some = samples_with({"--set", "workload.samples.count=7", "--report-samples", "1-2,6"});
    CHECK((some.count(1) == 1 && some.count(2) == 1 && some.count(6) == 1));
    fs::remove(workspace.folder() / "report.html");
    check_refused(workspace, {"--report", "r.html", "--report-samples", "3"}, "--report-samples 3: expected a number");
    check_refused(workspace, {"--report", "r.html", "--report-samples", "0-x"}, "--report-samples 0-x: expected");
    check_refused(workspace, {"--report", "r.html", "--report-samples", "all", "--set", "workload.samples.count=1001"},
                  "--report-samples all: 1001 samples, expected at most 1000");
    check_refused(workspace, {"--report-samples", "0"}, "--report-samples requires --report");
}

TEST_CASE("A hostile name in the configuration stays in the data of the HTML report") {
    Workspace const workspace;
    std::string const mesh = "a</script><img src=x onerror=alert(1)>.obj";  // a file in a folder, as it has a slash
    fs::create_directory(workspace.folder() / "a<");
    workspace.folder().write(mesh, "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
    require_done(workspace.run({"--set", "workload.object=./" + mesh, "--report", "report.html"}));
    std::string const page = workspace.text("report.html");
    CHECK(page.find("<img") == std::string::npos);
    CHECK(page.find("onerror=alert") != std::string::npos);  // as text in a string
    Json const rows = json_element(page, "data")["configuration"];
    CHECK(std::any_of(rows.begin(), rows.end(), [&mesh](Json const& row) {
        return row["value"].get<std::string>().find(mesh) != std::string::npos;
    }));
}

}  // namespace report_test
