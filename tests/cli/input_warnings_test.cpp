// Inputs of another unit or direction, in every command that builds a workload of them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace cli_input_warnings_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

CommandResult tool(SmallWorkspace const& workspace, Words words, Words const& settings = {}) {
    for (std::string const& setting : settings)
        words.insert(words.end(), {"--set", setting});
    return run_command(FASTER_SIM_BINARY, words, workspace.folder().path());
}

TEST_CASE("A depth image of another unit is told by every command that reads it", "[meshes]") {
    SmallWorkspace const workspace;
    require_done(tool(workspace, {"record", "config.yaml", "--out", "trace"}));  // whose depth.png counts 1/512 m
    auto const settings = [](char const* unit) {
        return Words{"workload.scene.depth_image=trace/depth.png", std::string("workload.scene.depth_unit_m=") + unit,
                     "workload.camera.fx=570", "workload.samples.count=2", "estimator.iterations=1"};
    };
    std::vector<Words> const commands{{"run", "config.yaml", "--out", "out"},
                                      {"record", "config.yaml", "--out", "recorded"},
                                      {"grip", "config.yaml"},
                                      {"estimate", "config.yaml", "--untimed", "-j", "1"}};
    for (Words const& command : commands) {
        CAPTURE(command[0]);
        CommandResult const wrong = tool(workspace, command, settings("0.01953125"));
        CHECK(wrong.exit_code == 0);
        CHECK_THAT(wrong.err, Contains("faster-sim: warning: trace/depth.png: ") &&
                                  Contains(" readings are beyond 3 m") &&
                                  Contains("(workload.scene.depth_unit_m = 0.01953125)"));
    }
    CHECK_THAT(tool(workspace, commands[0], settings("0.0005")).err,
               Contains("none of the readings is near it") &&
                   Contains("(workload.scene.depth_unit_m = 0.0005, or the poses)"));
    CommandResult const right = tool(workspace, {"run", "config.yaml"}, settings("0.001953125"));
    CHECK(right.exit_code == 0);
    CHECK_THAT(right.err, !Contains("warning"));
    CHECK_THAT(workspace.summary("out")["warnings"][0].get<std::string>(), Contains("depth_unit_m"));
}

TEST_CASE("A depth image of which nobody says which camera took it is told by every command that reads it",
          "[meshes]") {
    SmallWorkspace const workspace;
    require_done(tool(workspace, {"record", "config.yaml", "--out", "trace"}));
    Words settings{"workload.scene.depth_image=trace/depth.png", "workload.scene.depth_unit_m=0.001953125",
                   "workload.samples.count=2", "estimator.iterations=1"};
    for (Words const& command : {Words{"run", "config.yaml"}, Words{"record", "config.yaml", "--out", "recorded"},
                                 Words{"grip", "config.yaml"}, Words{"estimate", "config.yaml", "--untimed"}}) {
        CAPTURE(command[0]);
        CommandResult const result = tool(workspace, command, settings);
        require_done_with_warnings(result);
        CHECK_THAT(result.err,
                   Contains("workload.scene.depth_image = trace/depth.png: no key says which camera took it") &&
                       Contains("expected workload.camera.fx, fy, cx and cy"));
    }
    settings.push_back("workload.camera.cx=320");
    require_done(tool(workspace, {"run", "config.yaml"}, settings));
}

TEST_CASE("Of a depth image of one's own the truth is a configured pose, and nothing without one", "[meshes]") {
    SmallWorkspace const workspace;
    require_done(tool(workspace, {"record", "config.yaml", "--out", "trace"}));
    workspace.folder().write("own.yaml",
                             "accelerator: {raster_cores: 2, window: 60}\n"
                             "workload:\n"
                             "  object: tomato_soup_can\n"
                             "  camera: {fx: 570, fy: 570, cx: 319.5, cy: 239.5}\n"
                             "  scene: {depth_image: trace/depth.png, depth_unit_m: 0.001953125}\n"
                             "  samples: {count: 4}\n"
                             "estimator: {iterations: 1}\n");
    auto const estimated = [&](Words const& settings) {
        return tool(workspace, {"estimate", "own.yaml", "--untimed", "--out", "out"}, settings);
    };
    auto const found = [&] { return nlohmann::json::parse(workspace.text("out/estimate.json")); };
    CommandResult const nothing = estimated({});
    require_done_with_warnings(nothing);
    CHECK_THAT(nothing.err,
               Contains("neither estimator.box nor workload.pose is set, so samples begin all over the image"));
    CHECK_THAT(nothing.out, !Contains("from the truth"));
    CHECK((found()["truth"].is_null() && found()["add_mm"].is_null() && found()["boxes"].empty()));

    require_done(estimated({"estimator.box.left=250", "estimator.box.top=200", "estimator.box.width=100"}));
    CHECK((found()["truth"].is_null() && found()["boxes"].size() == 1));

    CommandResult const posed = estimated({"workload.pose.translation_m=[0,0,0.65]"});
    require_done(posed);
    CHECK_THAT(posed.out, Contains("from the truth"));
    CHECK(found()["boxes"].size() == 1);
}

TEST_CASE("A mesh in millimetres is one mistake, not one of the pose as well", "[meshes]") {
    SmallWorkspace const workspace;
    workspace.folder().write("mm.obj", "v 0 0 0\nv 90 0 0\nv 0 90 0\nv 0 0 90\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    CommandResult const result = tool(workspace, {"estimate", "config.yaml", "--untimed"},
                                      {"workload.object=./mm.obj", "estimator.iterations=1"});
    require_done_with_warnings(result);
    CHECK_THAT(result.err, Contains("mm.obj: is 90 m long") && !Contains("translation_m"));
}

TEST_CASE("An inside-out mesh and a camera that cannot be are told", "[meshes]") {
    SmallWorkspace const workspace;
    workspace.folder().write("in.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv 0 0 .1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
    CommandResult const result =
        tool(workspace, {"run", "config.yaml"}, {"workload.object=./in.obj", "workload.camera.cx=960"});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("in.obj: its faces are turned inwards (a volume of -0.000167 m^3)") &&
                               Contains("workload.camera.cx = 960: the optical axis is outside of the image"));
}

}  // namespace cli_input_warnings_test
