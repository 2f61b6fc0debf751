#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace critical_path_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;

TEST_CASE("The critical path says how every cycle came about, the same from both engines") {
    SmallWorkspace const workspace;
    for (std::string const engine : {"decoupled", "lockstep"}) {
        CommandResult const result =
            workspace.run({"--critical-path", "--out", engine, "--set", "simulation.engine=" + engine});
        require_done(result);
        CHECK_THAT(result.out, Contains("Critical path of core "));
    }
    Json const summary = workspace.summary("decoupled");
    std::uint64_t sum = 0;
    for (Json const& row : summary["critical_path"]["rows"])
        sum += row["cycles"].get<std::uint64_t>();
    CHECK(sum == summary["total_cycles"]);
    CHECK(summary["critical_path"] == workspace.summary("lockstep")["critical_path"]);
}

TEST_CASE("Without --critical-path and --sensitivities nothing of them is written") {
    SmallWorkspace const workspace;
    require_done(workspace.run({"--out", "plain"}));
    CHECK_FALSE(workspace.summary("plain").contains("critical_path"));
    CHECK_FALSE(workspace.summary("plain").contains("sensitivities"));
    CHECK(workspace.files_in("plain") == 6);
}

TEST_CASE("Sensitivities are what runs with the changed keys find") {
    SmallWorkspace const workspace;
    CommandResult const result = workspace.run({"--sensitivities", "--out", "out"});
    require_done(result);
    CHECK_THAT(result.out, Contains("Sensitivities: change of the "));
    CHECK(workspace.files_in("out") == 7);
    std::vector<std::string> const lines = lines_of(workspace.text("out/sensitivities.csv"));
    Json const summary = workspace.summary("out");
    CHECK(lines.size() == 1 + 2 * summary["sensitivities"].size());
    CHECK_THAT(workspace.text("out/sensitivities.csv"),
               Contains("accelerator.fifos.fragment_depth.depth,2,1,deadlock,,"));

    require_done(workspace.run({"--out", "changed", "--set", "accelerator.loops.rasterizer.setup.depth=13"}));
    for (Json const& row : summary["sensitivities"])
        if (row["key"] == "accelerator.loops.rasterizer.setup.depth")
            CHECK(row["up"]["total_cycles"] == workspace.summary("changed")["total_cycles"]);

    require_done(workspace.run({"--sensitivities", "--out", "lockstep", "--set", "simulation.engine=lockstep"}));
    CHECK(workspace.text("lockstep/sensitivities.csv") == workspace.text("out/sensitivities.csv"));
}

TEST_CASE("A recorded run is asked for critical path and sensitivities with other keys") {
    SmallWorkspace const workspace;
    require_done(workspace.run({"--events", "events"}));
    std::string const other = "accelerator.brams.depth_buffer.ports=4";
    require_done(workspace.run({"--critical-path", "--sensitivities", "--out", "run", "--set", other}));
    auto const tool = [&](std::vector<std::string> const& words) {
        require_done(run_command(FASTER_SIM_BINARY, words, workspace.folder().path()));
    };
    tool({"whatif", "events", "--critical-path", "--set", other, "--out", "whatif"});
    CHECK(workspace.summary("whatif")["critical_path"] == workspace.summary("run")["critical_path"]);
    tool({"sensitivities", "events", "--set", other, "--json", "steps.json"});
    Json const steps = Json::parse(workspace.text("steps.json"));
    Json const of_run = workspace.summary("run")["sensitivities"];
    CHECK(steps["total_cycles"] == workspace.summary("run")["total_cycles"]);
    REQUIRE(steps["sensitivities"].size() == of_run.size());
    for (std::size_t i = 0; i < of_run.size(); ++i)
        for (char const* step : {"down", "up"})
            CHECK(steps["sensitivities"][i][step]["outcome"] == of_run[i][step]["outcome"]);
    CommandResult const stuck =
        run_command(FASTER_SIM_BINARY, {"sensitivities", "events", "--set", "accelerator.fifos.fragment_depth.depth=1"},
                    workspace.folder().path());
    CHECK(stuck.exit_code == 2);
    CHECK_THAT(stuck.err, Contains("with these settings the run deadlocks in cycle "));
}

TEST_CASE("A deadlocked run has neither critical path nor sensitivities") {
    SmallWorkspace const workspace;
    CommandResult const result = workspace.run(
        {"--critical-path", "--sensitivities", "--out", "stuck", "--set", "accelerator.fifos.fragment_depth.depth=1"});
    CHECK(result.exit_code == 3);
    CHECK(workspace.files_in("stuck") == 1);
}

}  // namespace critical_path_test
