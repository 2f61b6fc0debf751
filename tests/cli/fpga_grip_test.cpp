#include <catch2/catch.hpp>
#include <set>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/report_page.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace fpga_grip_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

Words const fpga_grip{"--set", "accelerator.flow=fpga_grip"};

Words with_flow(Words words) {
    words.insert(words.end(), fpga_grip.begin(), fpga_grip.end());
    return words;
}

/// What only flow faster has.
Words const absent{"edge_map_builder", "edge_token", "edge_map", "object_map"};

void check_absent(std::string const& text, Words const& names) {
    for (std::string const& name : names) {
        CAPTURE(name);
        CHECK_THAT(text, !Contains(name));
    }
}

/// The second and third cell of every row of core 0.
Words rows_of(std::string const& csv, std::size_t cells) {
    Words rows;
    for (std::string const& line : lines_of(csv)) {
        std::size_t const begin = line.find(',') + 1;
        std::size_t end = line.find(',', begin);
        for (std::size_t i = 1; i < cells; ++i)
            end = line.find(',', end + 1);
        if (line.rfind("0,", 0) == 0)
            rows.push_back(line.substr(begin, end - begin));
    }
    return rows;
}

TEST_CASE("Flow fpga_grip lists the parts it has, and no others", "[fpga_grip]") {
    SmallWorkspace const workspace;
    CommandResult const result = workspace.run(
        with_flow({"--out", "out", "--images", "1", "--vcd", "w.vcd", "--timeline", "t.json", "--report", "r.html"}));
    require_done(result);
    check_absent(result.out, absent);
    CHECK(rows_of(workspace.text("out/loops.csv"), 2) == Words{"rasterizer,scan", "inlier_unit,clear",
                                                               "inlier_unit,fragment", "inlier_unit,sweep",
                                                               "inlier_unit,extract"});
    CHECK(rows_of(workspace.text("out/fifos.csv"), 1) ==
          Words{"sample_vertex", "sample_raster", "sample_observation", "vertex", "area", "area_reciprocal", "command",
                "fragment_depth", "fragment_index", "observed_depth", "observed_edge", "result"});
    auto const summary = workspace.summary("out");
    std::set<std::string> modules, brams;
    for (auto const& row : summary["modules"])
        modules.insert(row["module"]);
    for (auto const& row : summary["brams"])
        brams.insert(row["bram"]);
    CHECK(modules.size() == 7);
    CHECK(modules.count("edge_map_builder") == 0);
    CHECK(brams == std::set<std::string>{"depth_buffer", "line_buffers"});
    for (std::string const file : {"w.vcd", "w.states.txt", "w.stalls.txt", "w.gtkw", "t.json"})
        check_absent(workspace.text(file), absent);
    CHECK_THAT(workspace.text("w.states.txt"), Contains("extract"));
    CHECK_THAT(workspace.text("t.json"), Contains("extract"));
    CHECK(std::filesystem::exists(workspace.folder() / "out" / "images" / "sample_0000_edges.png"));
}

TEST_CASE("Flow faster knows nothing of the extraction", "[fpga_grip]") {
    SmallWorkspace const workspace;
    CommandResult const result = workspace.run({"--out", "out", "--vcd", "w.vcd"});
    require_done(result);
    CHECK_THAT(result.out, !Contains("extract"));
    CHECK(rows_of(workspace.text("out/loops.csv"), 2).size() == 7);
    for (std::string const file : {"out/loops.csv", "w.states.txt", "w.vcd"})
        CHECK_THAT(workspace.text(file), !Contains("extract"));
}

TEST_CASE("Both engines write the same files for flow fpga_grip", "[fpga_grip]") {
    SmallWorkspace const workspace;
    require_done(workspace.run(with_flow({"--out", "a"})));
    require_done(workspace.run(with_flow({"--out", "b", "--set", "simulation.engine=lockstep"})));
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"})
        CHECK(workspace.text("a" + file) == workspace.text("b" + file));
}

TEST_CASE("Keys of parts that the flow does not have are refused by name", "[fpga_grip]") {
    SmallWorkspace const workspace;
    auto const check = [&](Words const& words, std::string const& key, std::string const& flow) {
        check_bad_input(workspace.run(words), {key, "accelerator.flow", flow});
    };
    for (std::string const key : {"accelerator.fifos.edge_token.depth", "accelerator.loops.edge_map_builder.token.ii",
                                  "accelerator.brams.object_map.ports"})
        check(with_flow({"--set", key + "=3"}), key, "fpga_grip");
    check(with_flow({"--set", "accelerator.edge_map.algorithm=bounded"}), "accelerator.edge_map.algorithm",
          "fpga_grip");
    check({"--set", "accelerator.loops.inlier_unit.extract.ii=2"}, "accelerator.loops.inlier_unit.extract.ii",
          "faster");
    check({"--set", "accelerator.edge_extraction.neighbourhood=3"}, "accelerator.edge_extraction.neighbourhood",
          "faster");
    check_bad_input(workspace.run(with_flow({"--set", "accelerator.edge_extraction.neighbourhood=4"})),
                    {"accelerator.edge_extraction.neighbourhood=4", "an odd number"});
    check_bad_input(workspace.run({"--set", "accelerator.flow=fpga_gripp"}), {"accelerator.flow", "fpga_grip"});
    check_bad_input(workspace.run(with_flow({"--vcd", "w.vcd", "--vcd-modules", "edge_map_builder"})),
                    {"--vcd-modules edge_map_builder"});
}

TEST_CASE("A run of flow fpga_grip is recorded, and retimed with its own keys", "[fpga_grip][events]") {
    SmallWorkspace const workspace;
    require_done(
        workspace.run(with_flow({"--events", "events", "--critical-path", "--sensitivities", "--out", "run"})));
    CHECK_THAT(workspace.text("run/sensitivities.csv"), Contains("accelerator.edge_extraction.divider_latency"));
    CHECK_THAT(workspace.text("run/sensitivities.csv"), !Contains("edge_token"));
    Words const change{"--set", "accelerator.edge_extraction.divider_latency=60"};
    require_done(workspace.run(with_flow({"--out", "changed", change[0], change[1]})));
    require_done(run_command(FASTER_SIM_BINARY, {"whatif", "events", "--out", "retimed", change[0], change[1]},
                             workspace.folder().path()));
    for (std::string const file : {"/samples.csv", "/fifos.csv", "/loops.csv"})
        CHECK(workspace.text("retimed" + file) == workspace.text("changed" + file));
}

}  // namespace fpga_grip_test
