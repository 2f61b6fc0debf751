#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace poses_and_meshes_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;
using Json = nlohmann::ordered_json;
using Workspace = SmallWorkspace;

std::string const poses_key = "workload.samples.poses=";

/// A box of 60 x 50 x 40 units, outside in front, as OFF.
std::string box() {
    return "OFF\n8 12 0\n"
           "-30 -25 -20\n-30 -25 20\n-30 25 -20\n-30 25 20\n30 -25 -20\n30 -25 20\n30 25 -20\n30 25 20\n"
           "3 0 1 3\n3 0 3 2\n3 4 6 7\n3 4 7 5\n3 0 4 5\n3 0 5 1\n3 2 3 7\n3 2 7 6\n3 0 2 6\n3 0 6 4\n3 1 5 7\n3 1 7 "
           "3\n";
}

TEST_CASE("A run's poses read back give the same run, byte for byte", "[poses]") {
    Workspace const workspace;
    require_done(workspace.run({"--out", "drawn"}));
    require_done(workspace.run({"--set", poses_key + "drawn/poses.csv", "--out", "listed"}));
    for (char const* const table : {"samples.csv", "fifos.csv", "loops.csv", "all_loops.csv", "poses.csv"})
        CHECK(workspace.text(std::string("listed/") + table) == workspace.text(std::string("drawn/") + table));
    Json drawn = workspace.summary("drawn"), listed = workspace.summary("listed");
    CHECK(listed["configuration"]["workload.samples.poses"]["value"] == "drawn/poses.csv");
    for (Json* const summary : {&drawn, &listed}) {
        for (char const* const other : {"host", "made_by"})
            summary->erase(other);
        (*summary)["configuration"].erase("workload.samples.poses");
    }
    CHECK(listed == drawn);
}

TEST_CASE("The table of poses decides how many samples there are, and in which order", "[poses]") {
    Workspace const workspace;
    require_done(workspace.run({"--out", "three"}));
    Words const rows = lines_of(workspace.text("three/poses.csv"));
    REQUIRE(rows.size() == 4);
    workspace.folder().write("two.csv", rows[0] + "\n" + rows[3] + "\n" + rows[1] + "\n");
    require_done(workspace.run({"--set", poses_key + "two.csv", "--out", "two"}));
    CHECK(workspace.summary("two")["samples"] == 2);
    CHECK(workspace.summary("two")["configuration"]["workload.samples.count"]["value"] == 2);
    auto const counters = [&](std::string const& run, std::size_t row) {
        Words const cells = cells_of(lines_of(workspace.text(run + "/samples.csv"))[row]);
        return Words(cells.begin() + 5, cells.end());
    };
    CHECK(counters("two", 1) == counters("three", 3));
    CHECK(counters("two", 2) == counters("three", 1));
    CHECK(counters("two", 1) != counters("two", 2));
    check_bad_input(workspace.run({"--set", poses_key + "two.csv", "--set", "workload.samples.count=3"}),
                    {"workload.samples.count=3", "expected 2, as in the table of poses"});
}

TEST_CASE("A table of poses that is wrong is refused in one line", "[poses]") {
    Workspace const workspace;
    auto const check = [&](std::string const& table, Words const& parts) {
        workspace.folder().write("p.csv", table);
        CAPTURE(table);
        check_bad_input(workspace.run({"--set", poses_key + "p.csv", "--out", "out"}), parts);
        CHECK_FALSE(std::filesystem::exists(workspace.folder() / "out"));
    };
    std::string const unit = "1 0 0 0 1 0 0 0 1";
    check("R,t_m\n" + unit + ",0 0 1\n" + unit + ",0 0 0.05\n",
          {"p.csv:3: the pose has its origin at z = 0.05 m, expected at least 0.1 m"});
    check("R,t_m\n" + unit + ",0 x 1\n", {"p.csv:2: column t_m = 0 x 1, expected 3 finite numbers"});
    check("R,t\n" + unit + ",0 0\n", {"p.csv:2: column t = 0 0, expected 3 numbers parted by blanks, not 2"});
    check("R,t_m\n2 0 0 0 1 0 0 0 1,0 0 1\n", {"p.csv:2: column R = ", "expected a rotation"});
    check("R,t_m\n1 0 0 0 1 0 0 0 -1,0 0 1\n", {"p.csv:2", "this one mirrors"});
    check("R,x\n" + unit + ",0 0 1\n", {"p.csv:1: no column t_m in the header, expected R,t_m"});
    check("R,t_m\n", {"p.csv: no rows, expected one per sample"});
    check_bad_input(workspace.run({"--set", poses_key + "none.csv"}), {"none.csv: no such file"});
}

TEST_CASE("Poses as BOP's results have them are in millimetres", "[poses]") {
    Workspace const workspace;
    workspace.folder().write("m.csv", "R,t_m\n1 0 0 0 0 -1 0 1 0,0.01 0.02 0.65\n");
    workspace.folder().write("mm.csv",
                             "scene_id,im_id,obj_id,score,R,t,time\n1,1,1,0.5,1 0 0 0 0 -1 0 1 0,10 20 650,-1\n");
    require_done(workspace.run({"--set", poses_key + "m.csv", "--out", "m"}));
    require_done(workspace.run({"--set", poses_key + "mm.csv", "--out", "mm"}));
    CHECK(workspace.text("m/poses.csv") == "sample,R,t_m\n0,1 0 0 0 0 -1 0 1 0,0.01 0.02 0.65\n");
    CHECK(workspace.text("mm/samples.csv") == workspace.text("m/samples.csv"));
    workspace.folder().write("nameless.csv", "1,1,1,0.5,1 0 0 0 0 -1 0 1 0,+10 20 650,-1\n");
    require_done(workspace.run({"--set", poses_key + "nameless.csv", "--out", "nameless"}));
    CHECK(workspace.text("nameless/samples.csv") == workspace.text("m/samples.csv"));
    workspace.folder().write("nameless.csv", "1,1,1,0.5,1 0 0 0 0 -1 0 1 0,10 20 5,-1\n");
    check_bad_input(workspace.run({"--set", poses_key + "nameless.csv"}), {"nameless.csv:1: the pose has its origin"});
}

TEST_CASE("A mesh in millimetres is told, as are samples that draw nothing, and a scale helps", "[meshes]") {
    Workspace const workspace;
    workspace.folder().write("box.off", box());
    Words const box_is{"--set", "workload.object=./box.off"};
    Words large = box_is;
    large.insert(large.end(), {"--out", "large", "--report", "large.html"});
    CommandResult const result = workspace.run(large);
    CHECK(result.exit_code == 0);
    Words const lines = lines_of(result.err);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] ==
          "faster-sim: warning: box.off: is 60 m long, which looks like millimetres; expected less than 3 m "
          "(workload.mesh_files.scale: 0.001 reads millimetres)");
    CHECK_THAT(lines[1], Contains("warning: 3 of 3 samples draw no pixel, the first is sample 0"));
    Json const warnings = workspace.summary("large")["warnings"];
    REQUIRE(warnings.size() == 2);
    CHECK("faster-sim: warning: " + warnings[0].get<std::string>() == lines[0]);
    CHECK_THAT(workspace.text("large.html"), Contains("looks like millimetres"));

    Words recorded = box_is;
    recorded.insert(recorded.end(), {"--events", "events"});
    CHECK(workspace.run(recorded).exit_code == 0);
    require_done(run_command(FASTER_SIM_BINARY, {"whatif", "events", "--out", "whatif"}, workspace.folder().path()));
    CHECK(workspace.summary("whatif")["warnings"] == warnings);

    Words small = box_is;
    small.insert(small.end(), {"--set", "workload.mesh_files.scale=0.001", "--out", "small"});
    require_done(workspace.run(small));
    CHECK_FALSE(workspace.summary("small").contains("warnings"));
    CHECK(std::stoi(cells_of(lines_of(workspace.text("small/samples.csv"))[1])[5]) > 1000);
    check_bad_input(workspace.run({"--set", "workload.mesh_files.scale=0"}), {"workload.mesh_files.scale"});
}

TEST_CASE("A sample that draws nothing beside others that do is told as well", "[meshes]") {
    Workspace const workspace;
    workspace.folder().write("p.csv", "R,t_m\n1 0 0 0 0 -1 0 1 0,0 0 0.65\n1 0 0 0 0 -1 0 1 0,-30 0 0.65\n");
    CommandResult const result = workspace.run({"--set", poses_key + "p.csv"});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("1 of 2 samples draw no pixel, the first is sample 1"));
}

}  // namespace poses_and_meshes_test
