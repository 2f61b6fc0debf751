#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/report_page.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace hazards_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;

std::string const stages = "accelerator.loops.inlier_unit.fragment.depth_buffer.";

Json row_of(Json const& rows, std::string const& loop, std::string const& bram) {
    for (Json const& row : rows)
        if (row["loop"] == loop && row["bram"] == bram)
            return row;
    return {};
}

TEST_CASE("run --hazards tells them in text, summary and page, and leaves the other files as they are") {
    SmallWorkspace const workspace;
    CommandResult const plain = workspace.run({"--out", "plain"});
    CommandResult const told = workspace.run({"--hazards", "--out", "told", "--report", "page.html"});
    require_done(plain);
    require_done(told);
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"})
        CHECK(workspace.text("told" + file) == workspace.text("plain" + file));
    CHECK_FALSE(workspace.summary("plain").contains("hazards"));
    CHECK_THAT(plain.out, !Contains("Hazards"));
    Json const rows = workspace.summary("told")["hazards"];
    CHECK(rows.size() == 2 * 3);  // cores; token on two maps, fragment
    Json const fragment = row_of(rows, "fragment", "depth_buffer");
    CHECK(fragment["read_stage"] == 7);
    CHECK(fragment["write_stage"] == 9);
    CHECK(fragment["span"] == 3);
    CHECK(fragment["distances"] == Json::array({0, 0}));
    CHECK(fragment["smallest_distance"].is_null());
    Json const token = row_of(rows, "token", "object_map");
    CHECK(token["hazards"] == token["distances"][0]);
    CHECK(token["handling"] == "report");
    Json const sums = json_element(workspace.text("page.html"), "data")["hazards"];
    CHECK(sums.size() == 3);
    std::uint64_t hazards = 0;
    for (Json const& row : rows)
        hazards += row["hazards"].get<std::uint64_t>();
    CHECK(hazards > 0);
    CHECK(row_of(sums, "token", "object_map")["hazards"] == hazards);
    CHECK_THAT(told.out, Contains("edge_map_builder.token on object_map: " + std::to_string(hazards) + " hazards"));
    require_done(run_command(FASTER_SIM_BINARY, {"compare", "plain", "told"}, workspace.folder().path()));
}

TEST_CASE("Stages of a loop's accesses are keys, which have to lie in its pipeline") {
    SmallWorkspace const workspace;
    require_done(workspace.run({"--hazards", "--out", "a", "--set", stages + "write_stage=8"}));
    CHECK(row_of(workspace.summary("a")["hazards"], "fragment", "depth_buffer")["span"] == 2);
    require_done(workspace.run({"--hazards", "--out", "b", "--set", "accelerator.loops.inlier_unit.fragment.depth=5"}));
    Json const shorter = row_of(workspace.summary("b")["hazards"], "fragment", "depth_buffer");
    CHECK(shorter["write_stage"] == 4);  // the last
    CHECK(shorter["span"] == 3);
    require_done(workspace.run({"--hazards", "--out", "c", "--set", stages + "hazards=forward"}));
    Json const forwarded = row_of(workspace.summary("c")["hazards"], "fragment", "depth_buffer");
    CHECK(forwarded["handling"] == "forward");
    CHECK(forwarded["comparators"] == 2);
    CHECK(workspace.summary("c")["total_cycles"] == workspace.summary("a")["total_cycles"]);
    check_bad_input(workspace.run({"--set", stages + "write_stage=10"}), {stages + "write_stage=10", "at most 9"});
    check_bad_input(workspace.run({"--set", stages + "write_stage=5"}),
                    {stages + "write_stage=5", stages + "read_stage"});
    std::string const loop = "accelerator.loops.inlier_unit.fragment.depth=";
    check_bad_input(workspace.run({"--set", loop + "1000000", "--set", stages + "write_stage=600000", "--set",
                                   stages + "hazards=interlock"}),
                    {stages + "write_stage=600000", "at most 524286 behind " + stages + "read_stage = 7"});
    check_bad_input(workspace.run({"--set", stages + "hazards=wait"}), {"wait", "report, interlock, forward"});
}

TEST_CASE("Iterations wait with hazards interlock, which a recording was made with or without") {
    SmallWorkspace const workspace;
    std::string const map = "accelerator.loops.edge_map_builder.token.object_map.";
    require_done(workspace.run({"--events", "a.events", "--out", "a"}));
    CommandResult const run =
        workspace.run({"--hazards", "--events", "b.events", "--out", "b", "--set", map + "hazards=interlock"});
    require_done(run);
    Json const token = row_of(workspace.summary("b")["hazards"], "token", "object_map");
    CHECK(token["handling"] == "interlock");
    CHECK(token["comparators"] == 2);
    CHECK_THAT(run.out, Contains(token["hazards"].dump() + " hazards, for which iterations wait "));
    CHECK(token["interlock_cycles"] > 0);
    CHECK(token["interlock_cycles"] <= token["hazards"]);  // once for every word, and a cycle each
    CommandResult const cosim = run_command(
        FASTER_SIM_BINARY, {"cosim", FASTER_SOURCE_DIR "/traces/one_triangle", "--set", map + "hazards=interlock"},
        workspace.folder().path());
    check_bad_input(cosim, {map + "hazards = interlock: expected report or forward"});
    auto const whatif = [&](std::string const& events, std::string const& setting) {
        return run_command(FASTER_SIM_BINARY, {"whatif", events, "--set", setting}, workspace.folder().path());
    };
    require_done(whatif("b.events", "accelerator.loops.edge_map_builder.token.ii=3"));
    require_done(whatif("b.events", "accelerator.loops.edge_map_builder.token.depth=9"));
    require_done(whatif("b.events", stages + "write_stage=8"));  // of others
    for (std::string const& refused : {map + "hazards=report", map + "write_stage=2", stages + "hazards=interlock"})
        check_bad_input(whatif("b.events", refused), {refused, "decides which iterations wait", "use faster-sim run"});
    check_bad_input(whatif("a.events", map + "hazards=interlock"), {"decides which iterations wait"});
    require_done(whatif("a.events", map + "hazards=forward"));
}

}  // namespace hazards_test
