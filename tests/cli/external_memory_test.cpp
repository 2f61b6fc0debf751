#include <catch2/catch.hpp>
#include <regex>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace external_memory_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// Two cores behind a memory that is slow enough to be felt.
class Workspace {
  public:
    CommandResult run(Words words) const {
        for (char const* const setting : {"model=axi", "dram_gb_per_s=0.5", "ports=1"})
            words.insert(words.end(), {"--set", std::string("accelerator.memory.") + setting});
        return small.run(words);
    }
    CommandResult tool(Words const& words) const {
        return run_command(FASTER_SIM_BINARY, words, small.folder().path());
    }
    SmallWorkspace small;
};

TEST_CASE("A run behind external memory says what moved, and what compute and memory would take alone") {
    Workspace const workspace;
    require_done(workspace.run({"--out", "out", "--report", "page.html"}));
    Json const summary = workspace.small.summary("out");
    Json const& memory = summary["external_memory"];
    CHECK(memory["ports"].size() == 1);
    CHECK(memory["masters"].size() == 8);
    std::uint64_t bytes = 0, over_time = 0;
    for (Json const& master : memory["masters"])
        bytes += master["bytes"].get<std::uint64_t>();
    for (Json const& stretch : memory["over_time"]["stretches"])
        over_time += stretch["bytes"].get<std::uint64_t>();
    CHECK(memory["bytes"] == bytes);
    CHECK(over_time == bytes);
    auto const total = summary["total_cycles"].get<std::uint64_t>();
    CHECK(memory["memory_alone_cycles"].get<std::uint64_t>() <= total);
    require_done(workspace.small.run({"--out", "ideal"}));
    CHECK(memory["compute_alone_cycles"] == workspace.small.summary("ideal")["total_cycles"]);
    CHECK(workspace.small.summary("ideal").count("external_memory") == 0);
    CHECK_THAT(workspace.small.text("page.html"), Contains("external-memory-chart"));
}

TEST_CASE("Both engines record the same behind external memory") {
    Workspace const workspace;
    for (std::string const engine : {"lockstep", "decoupled"})
        require_done(workspace.run({"--vcd", engine + ".vcd", "--timeline", engine + ".json", "--events", engine,
                                    "--set", "simulation.engine=" + engine}));
    for (std::string const kind : {"", ".vcd", ".json"}) {
        std::string const recorded = workspace.small.text("lockstep" + kind);
        CHECK(recorded == workspace.small.text("decoupled" + kind));
        CHECK(!recorded.empty());
    }
    CHECK_THAT(workspace.small.text("lockstep.json"), Contains("\"memory\""));
    CHECK_THAT(workspace.small.text("lockstep.stalls.txt"), Contains("memory"));
}

TEST_CASE("whatif knows other memories, and says why it does not know what was not fetched") {
    Workspace const workspace;
    require_done(workspace.run({"--events", "events"}));
    require_done(workspace.tool({"whatif", "events", "--set", "accelerator.memory.ports=2", "--set",
                                 "accelerator.memory.prefetch=true", "--out", "retimed"}));
    require_done(workspace.small.run({"--out", "run", "--set", "accelerator.memory.model=axi", "--set",
                                      "accelerator.memory.dram_gb_per_s=0.5", "--set", "accelerator.memory.ports=2",
                                      "--set", "accelerator.memory.prefetch=true"}));
    for (std::string const table : {"samples.csv", "fifos.csv", "loops.csv"})
        CHECK(workspace.small.text("retimed/" + table) == workspace.small.text("run/" + table));
    CHECK(workspace.small.summary("retimed")["external_memory"] == workspace.small.summary("run")["external_memory"]);
    check_bad_input(workspace.tool({"whatif", "events", "--set", "accelerator.memory.mesh=on_chip"}),
                    {"accelerator.memory.mesh decides what is fetched, which was recorded"});
    require_done(workspace.small.run({"--events", "ideal"}));
    check_bad_input(workspace.tool({"whatif", "ideal", "--set", "accelerator.memory.model=axi"}),
                    {"accelerator.memory.model was ideal in the recorded run"});
    CommandResult const sensitivities = workspace.tool({"sensitivities", "events"});
    require_done(sensitivities);
    CHECK_THAT(sensitivities.out, Contains("accelerator.memory.request_cycles"));
    auto const of_ideal = [&workspace](Words const& events) {
        Words words{"sensitivities", "--json", "sensitivities.json"};
        words.insert(words.end(), events.begin(), events.end());
        require_done(workspace.tool(words));
        return Json::parse(workspace.small.text("sensitivities.json"))["sensitivities"];
    };
    CHECK_THAT(of_ideal({"ideal"}).dump(), !Contains("accelerator.memory."));
    CHECK(of_ideal({"events", "--set", "accelerator.memory.model=ideal"}) == of_ideal({"ideal"}));
}

TEST_CASE("size-fifos says what it proves behind external memory") {
    Workspace const workspace;
    require_done(workspace.run({"--events", "events"}));
    CommandResult const sized =
        workspace.tool({"size-fifos", "events", "--within", "5", "--points", "0", "--out", "sizes"});
    require_done(sized);
    auto const sizing = Json::parse(workspace.small.text("sizes/sizing.json"));
    CHECK(sizing["shares_memory"] == true);
    CHECK(sizing["answer"]["total_cycles"] <= sizing["bound_cycles"]);
    CHECK(sizing["proven"] == sizing["unproven_because"].is_null());
    CHECK(sizing["proven"] == (sizing["answer"]["cost_luts"] <= sizing["least_cost_luts"]));
    CHECK_THAT(sized.out, Contains("The cores share a memory"));
    Words depths{"--out", "run"};
    for (auto const& [fifo, depth] : sizing["answer"]["depths"].items())
        depths.insert(depths.end(), {"--set", "accelerator.fifos." + fifo + ".depth=" + depth.dump()});
    require_done(workspace.run(depths));
    CHECK(workspace.small.summary("run")["total_cycles"] == sizing["answer"]["total_cycles"]);
}

TEST_CASE("A deadlock behind external memory names who waits, and the path names memory") {
    Workspace const workspace;
    CommandResult const stuck = workspace.run({"--set", "accelerator.fifos.fragment_depth.depth=1"});
    CHECK(stuck.exit_code == 3);
    CHECK_THAT(stuck.err, Contains("inlier_unit"));
    CommandResult const path = workspace.run({"--critical-path"});
    require_done(path);
    CHECK_THAT(path.out, Contains("  memory  "));
}

TEST_CASE("What is loaded before a recorded run changes no sensitivity") {
    Workspace const workspace;
    Words const settings{"--set", "accelerator.memory.mesh=on_chip", "--events", "events", "--out", "out"};
    require_done(workspace.run(settings));
    Json const summary = workspace.small.summary("out");
    CHECK(summary["load_cycles"] > 0);
    require_done(workspace.tool({"sensitivities", "events", "--csv", "rows.csv"}));
    CHECK_THAT(workspace.small.text("rows.csv"), Contains("accelerator.fifos.sample_vertex.depth,2,3,finished," +
                                                          summary["total_cycles"].dump() + ",0,"));
}

}  // namespace external_memory_test
