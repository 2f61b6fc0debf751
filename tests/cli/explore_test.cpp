#include <catch2/catch.hpp>
#include <httplib.h>
#include <thread>

#include "dataflow/base/cycles.hpp"
#include "faster/dataflow_names.hpp"
#include "support/explore_questions.hpp"
#include "support/report_page.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace explore_test {

using faster::Cycles;
using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// The event file of a small run, and what its page asks.
class Explored {
  public:
    Explored() {
        require_done(workspace_.run({"--events", "events"}));
        process_ = std::make_unique<ExploreProcess>(FASTER_SIM_BINARY, Words{"events"}, folder());
    }

    std::filesystem::path const& folder() const { return workspace_.folder().path(); }
    ExploreProcess& process() { return *process_; }
    httplib::Result post(std::string const& path, std::string const& body) { return post_to(*process_, path, body); }
    Json ask(std::string const& question, Json const& request, int status = 200) {
        return faster::test::ask(*process_, question, request, status);
    }
    /// The state of a job once it has ended.
    Json ended(std::string const& job) {
        Json state;
        do {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            state = ask("state", {{"job", job}});
        } while (state["state"] == "running");
        return state;
    }
    CommandResult tool(Words const& words) { return run_command(FASTER_SIM_BINARY, words, folder()); }
    Json summary(std::string const& run) { return workspace_.summary(run); }

  private:
    SmallWorkspace workspace_;
    std::unique_ptr<ExploreProcess> process_;
};

TEST_CASE("explore answers what whatif says, and what it exports runs as long") {
    Explored explored;
    Words const settings{"accelerator.fifos.edge_token.depth=16", "accelerator.brams.depth_buffer.ports=3",
                         "accelerator.raster_cores=3"};
    Json const figures = explored.ask("retime", {{"set", settings}});
    Words words{"whatif", "events", "--out", "whatif"};
    for (std::string const& setting : settings)
        words.insert(words.end(), {"--set", setting});
    require_done(explored.tool(words));
    Json const summary = explored.summary("whatif");
    CHECK(figures["total_cycles"] == summary["total_cycles"]);
    CHECK(figures["milliseconds"] == summary["milliseconds"]);
    CHECK(figures["bound_by"] == summary["bound_by"]);

    std::ofstream(explored.folder() / "exported.yaml") << figures["yaml"].get<std::string>();
    require_done(explored.tool({"run", "exported.yaml", "--critical-path", "--out", "run"}));
    Json const run = explored.summary("run");
    CHECK(run["total_cycles"] == summary["total_cycles"]);
    CHECK(explored.ask("path", {{"set", settings}}) == run["critical_path"]);
    CHECK(explored.process().interrupt() == 0);
}

TEST_CASE("The page is told where a machine does not fit into memory") {
    Explored explored;
    Words settings{"accelerator.raster_cores=1024"};
    for (std::string const fifo : {"edge_token", "command", "fragment_depth", "fragment_index", "observed_depth",
                                   "observed_edge", "edge_map", "area", "area_reciprocal", "vertex"})
        settings.push_back("accelerator.fifos." + fifo + ".depth=1048576");
    for (Words const& asked :
         {Words{"retime", ""}, Words{"path", ""}, Words{"start", "sensitivities"}, Words{"start", "sizing"}}) {
        Json const answer = explored.ask(asked[0], {{"set", settings}, {"job", asked[1]}, {"within", 5}}, 400);
        CHECK_THAT(answer.dump(), Contains("explore: would take about ") && Contains("of memory"));
    }
}

TEST_CASE("A sample's timeline lies where the run has the sample, and has parts") {
    Explored explored;
    require_done(explored.tool({"run", "config.yaml", "--report", "report.html", "--report-samples", "1"}));
    Json const shown = json_element(content_of(explored.folder() / "report.html"), "data")["timelines"];
    auto const expected =
        std::find_if(shown.begin(), shown.end(), [](Json const& timeline) { return timeline["sample"] == 1; });
    REQUIRE(expected != shown.end());
    Json const whole = explored.ask("timeline", {{"sample", 1}});
    for (char const* const name : {"core", "begin", "end"})
        CHECK(whole[name] == (*expected)[name]);
    Cycles const middle = (whole["begin"].get<Cycles>() + whole["end"].get<Cycles>()) / 2;
    Json const part = explored.ask("timeline", {{"sample", 1}, {"from", middle}, {"to", middle + 100}});
    CHECK(part["begin"] == middle);
    CHECK(part["end"] == middle + 100);
    CHECK(part["spans"].size() > 0);
    for (Json const& span : part["spans"])
        CHECK((span[3] < middle + 100 && span[4] > middle));
    CHECK_THAT(explored.ask("timeline", {{"sample", 3}}, 400)["error"].get<std::string>(),
               Contains("sample = 3, expected one below 3"));
}

TEST_CASE("The schedules of a loop's accesses take as long as its ports demand") {
    Explored explored;
    for (Words const& settings :
         {Words{}, Words{"accelerator.brams.depth_buffer.partition.type=cyclic",
                         "accelerator.brams.depth_buffer.partition.factor=2", "accelerator.brams.edge_map.ports=1"}}) {
        std::size_t conflicts = 0;
        Json const figures = explored.ask("retime", {{"set", settings}});
        for (Json const& loop : figures["schedules"]) {
            CAPTURE(loop.dump());
            std::size_t longest = 1;
            for (Json const& memory : loop["memories"]) {
                longest = std::max(longest, memory["cycles"].size());
                for (Json const& cycle : memory["cycles"])
                    CHECK((!cycle.empty() && cycle.size() <= memory["ports"]));
            }
            CHECK(loop["ports"] == longest);
            CHECK(loop["ii"] ==
                  std::max({longest, loop["target"].get<std::size_t>(), loop["recurrence"].get<std::size_t>()}));
            conflicts += longest > 1 ? 1 : 0;
        }
        CHECK(conflicts > 0);
    }
}

TEST_CASE("explore's complaints are those of whatif") {
    Explored explored;
    for (std::string const setting : {"accelerator.fifos.vertx.depth=4", "accelerator.fifos.vertex.depth=0",
                                      "accelerator.window=80", "accelerator.fifos=1", "x"}) {
        CommandResult const whatif = explored.tool({"whatif", "events", "--set", setting});
        std::string const line =
            "faster-sim: " + explored.ask("retime", {{"set", {setting}}}, 400)["error"].get<std::string>() + "\n";
        CHECK(line == whatif.err);
    }
    CHECK_THAT(explored.ask("retime", {{"set", 3}}, 400)["error"].get<std::string>(), Contains("set = 3, expected"));
    CHECK_THAT(explored.ask("retyme", Json::object(), 400)["error"].get<std::string>(),
               Contains("unknown question retyme"));
    CHECK_THAT(explored.ask("start", {{"job", "sizing"}, {"within", -1}}, 400)["error"].get<std::string>(),
               Contains("within = -1, expected a number from 0"));
    CHECK(explored.post(explored.process().home() + "retime", std::string(200000, 'x'))->status == 413);
}

TEST_CASE("explore answers nobody who does not know its token, on no other address than this host's") {
    Explored explored;
    httplib::Client client("127.0.0.1", explored.process().port());
    CHECK(client.Get("/")->status == 403);
    CHECK(client.Get("/0123456789abcdef0123456789abcdef/")->status == 403);
    CHECK(explored.post("/retime", "{}")->status == 403);
    auto const page = client.Get(explored.process().home());
    CHECK(page->status == 200);
    CHECK_THAT(page->body, Contains("connect-src 'self'"));
    CHECK_THAT(explored.process().said(), Contains("ssh -N -L " + std::to_string(explored.process().port())));
    std::string const port = std::to_string(explored.process().port());
    check_bad_input(explored.tool({"explore", "events", "--port", port}),
                    {"--port " + port + ": cannot be listened on, expected a free port"});
}

TEST_CASE("explore works out sensitivities and sizes FIFOs in the background") {
    Explored explored;
    explored.ask("start", {{"job", "sensitivities"}, {"set", Json::array()}});
    explored.ask("start", {{"job", "sizing"}, {"within", 5}, {"set", Json::array()}});
    Json const sensitivities = explored.ended("sensitivities");
    require_done(explored.tool({"sensitivities", "events", "--json", "sensitivities.json"}));
    Json expected = Json::parse(content_of(explored.folder() / "sensitivities.json"))["sensitivities"];
    for (Json& row : expected)  // the page does without slack
        for (char const* side : {"down", "up"})
            row[side].erase("slack");
    CHECK(sensitivities["result"]["sensitivities"] == expected);
    Json const sizing = explored.ended("sizing");
    require_done(explored.tool({"size-fifos", "events", "--within", "5", "--out", "sized"}));
    Json answer = sizing["result"]["answer"];
    answer.erase("cost_of_cores");
    CHECK(answer == Json::parse(content_of(explored.folder() / "sized/sizing.json"))["answer"]);

    explored.ask("start", {{"job", "sizing"}, {"within", 0}, {"set", Json::array()}});
    explored.ask("cancel", {{"job", "sizing"}});
    CHECK(explored.ended("sizing")["state"] == "cancelled");
}

TEST_CASE("The critical path of cores that share a memory is that of a run") {
    SmallWorkspace const workspace;
    Words const axi{"--set", "accelerator.memory.model=axi"};
    Words run = axi, explore = axi;
    run.insert(run.end(), {"--critical-path", "--out", "run"});
    require_done(workspace.run(run));
    explore.insert(explore.begin(), "config.yaml");
    ExploreProcess const process(FASTER_SIM_BINARY, explore, workspace.folder().path());
    CHECK(ask(process, "path", Json::object()) == workspace.summary("run")["critical_path"]);
}

TEST_CASE("With an ideal memory a module's cycles keep the classes of the recorded run", "[explore]") {
    SmallWorkspace const workspace;
    ExploreProcess const process(FASTER_SIM_BINARY, {"config.yaml", "--set", "accelerator.memory.model=axi"},
                                 workspace.folder().path());
    Json const recorded = ask(process, "retime", {{"set", Words()}})["modules"];
    Json const ideal = ask(process, "retime", {{"set", Words{"accelerator.memory.model=ideal"}}})["modules"];
    REQUIRE(ideal.size() == recorded.size());
    for (std::size_t i = 0; i < ideal.size(); ++i) {
        CAPTURE(ideal[i]["module"]);
        CHECK(ideal[i]["cycles"].size() == recorded[i]["cycles"].size());
    }
}

TEST_CASE("explore runs a configuration first, and a deadlock is something that it shows") {
    SmallWorkspace const workspace;
    ExploreProcess process(FASTER_SIM_BINARY, {"config.yaml", "--set", "accelerator.raster_cores=1"},
                           workspace.folder().path());
    auto const retimed = [&](Json const& request) { return ask(process, "retime", request); };
    CHECK(retimed(Json::object())["cores"] == 1);
    CHECK(retimed(Json::object())["outcome"] == "finished");
    Json const deadlock = retimed({{"set", Words{"accelerator.fifos.fragment_depth.depth=1"}}});
    CHECK(deadlock["outcome"] == "deadlock");
    CHECK(deadlock["deadlock"]["wait_cycle"].size() > 1);
    CHECK(process.interrupt() == 0);

    auto const explore = [&](Words words) {
        words.insert(words.begin(), "explore");
        return run_command(FASTER_SIM_BINARY, words, workspace.folder().path());
    };
    check_bad_input(explore({"nosuch.yaml"}), {"nosuch.yaml: no such file"});
    CommandResult const stuck = explore({"config.yaml", "--set", "accelerator.fifos.fragment_depth.depth=1"});
    CHECK(stuck.exit_code == 3);
    CHECK_THAT(stuck.err, Contains("wait-for cycle"));
}

}  // namespace explore_test
