#include <catch2/catch.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "poses/bop/pose_results.hpp"
#include "support/bop_folder.hpp"
#include "support/command.hpp"
#include "support/decoded_png.hpp"
#include "support/is_instrumented.hpp"
#include "support/tool_output.hpp"

namespace evaluate_test {

using namespace faster;
using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

std::string const header = "scene_id,im_id,obj_id,score,R,t,time\n";

/// A dataset, and two methods' results: one right, the other 3 cm off.
class Workspace {
  public:
    Workspace() {
        work_.write("right.csv", results(0));
        work_.write("off.csv", results(0.03));
    }
    CommandResult evaluate(Words arguments) const {
        arguments.insert(arguments.begin(), "evaluate");
        for (std::string& argument : arguments)
            argument = argument == "DATASET" ? dataset_.path().string() : argument;
        return run_command(FASTER_SIM_BINARY, arguments, work_.path());
    }
    CommandResult evaluate_text(std::string const& text) const {
        work_.write("wrong.csv", text);
        return evaluate({"wrong.csv", "DATASET", "--out", "out"});
    }
    std::string text(std::string const& name) const { return content_of(work_ / name); }
    TempFolder const& work() const { return work_; }
    BopFolder const& dataset() const { return dataset_; }

  private:
    static std::string results(double shift_m) {
        std::vector<bop::PoseEstimate> estimates;
        for (int const scene : {1, 2}) {
            for (int const image : {0, 3}) {
                for (int const object : {BopFolder::box, BopFolder::cylinder}) {
                    estimates.push_back({{scene, image}, object, 0.5, BopFolder::pose_of(object, image), 0.25, 0, {}});
                    estimates.back().pose.translation.z() += shift_m;
                }
            }
        }
        return bop::pose_results_csv(estimates);
    }

    TempFolder work_;
    BopFolder dataset_;
};

TEST_CASE("Nothing is judged in an image of which the camera is not known", "[evaluate]") {
    for (auto const& [from, to] : std::map<std::string, std::string>{{"\"cam_K\": [", "\"cam_K\": [-"},
                                                                     {"cam_K", "cam_model"},
                                                                     {"\"depth_scale\": 0.1", "\"depth_scale\": 0"}}) {
        Workspace const workspace;
        workspace.dataset().replace("test/000001/scene_camera.json", from, to);
        check_bad_input(workspace.evaluate({"right.csv", "DATASET", "--out", "out"}),
                        {"scene_camera.json: 0", "expected"});
        CHECK_FALSE(std::filesystem::exists(workspace.work() / "out"));
    }
}

TEST_CASE("evaluate prints a table, and writes tables, plots and a page", "[evaluate]") {
    Workspace const workspace;
    CommandResult const result =
        workspace.evaluate({"right.csv", "off.csv", "DATASET", "--out", "out", "--bootstraps", "100"});
    require_done(result);
    CHECK_THAT(result.out, Contains("8 instances in 4 images") &&
                               Contains("| all | right | 8 | 8 | 100.0 (100.0 .. 100.0) |") &&
                               Contains("| mean | right | 8 | 8 | - | - | 100.0 (100.0 .. 100.0) |") &&
                               Contains("| AR |") && Contains("Points more than right") &&
                               Contains("right: 0.250 s per image") && Contains("written: out"));
    CHECK_THAT(workspace.text("out/evaluation.html"), Contains("<code>faster-sim evaluate "));
    for (std::string const file : {"scores.csv", "errors.csv", "curves.csv", "evaluation.html"})
        CHECK_THAT(workspace.text("out/" + file), Contains("off"));
    auto const json = nlohmann::json::parse(workspace.text("out/evaluation.json"));
    CHECK(json["rows"].size() == 8);
    CHECK(json["rows"][6]["object"] == "all");
    CHECK(json["rows"][6]["scores"]["add_4cm"][0] == 100);
    CHECK(json["rows"][6]["more_than_first"]["add_2cm"][0] == -100);
    for (std::string const plot : {"accuracy_add_s.png", "accuracy_add.png"})
        CHECK(header_of_decoded(workspace.text("out/" + plot)).width == 3 * 330);
    CHECK(entries_in(workspace.work() / "out") == 7);
}

TEST_CASE("evaluate writes the same bytes whatever the threads, and over what it wrote before", "[evaluate]") {
    Workspace const workspace;
    require_done(workspace.evaluate({"off.csv", "DATASET", "--out", "one", "--jobs", "1", "--seed", "7"}));
    require_done(workspace.evaluate({"right.csv", "DATASET", "--out", "four"}));
    require_done(workspace.evaluate({"off.csv", "DATASET", "--out", "four", "--jobs", "4", "--seed", "7"}));
    for (auto const& entry : std::filesystem::directory_iterator(workspace.work() / "one")) {
        std::string const name = entry.path().filename().string();
        CAPTURE(name);
        CHECK(workspace.text("one/" + name) == workspace.text("four/" + name));
    }
}

TEST_CASE("evaluate takes models from elsewhere", "[evaluate]") {
    Workspace const workspace;
    std::filesystem::rename(workspace.dataset() / "models", workspace.work() / "elsewhere");
    check_bad_input(workspace.evaluate({"right.csv", "DATASET"}), {"models: no such folder"});
    require_done(workspace.evaluate({"right.csv", "--models", "elsewhere", "DATASET"}));
}

TEST_CASE("evaluate says what stands in a mesh's place before it says how long it would take", "[evaluate]") {
    Workspace const workspace;
    std::filesystem::path const mesh = workspace.dataset() / "models/obj_000005.ply";
    std::filesystem::remove(mesh);
    auto const says = [&](char const* what) {
        check_bad_input(workspace.evaluate({"right.csv", "DATASET"}), {"obj_000005.ply: ", what});
        std::filesystem::remove(mesh);
    };
    std::filesystem::create_directory(mesh);
    says("is a folder, expected a file");
    std::filesystem::create_symlink("nowhere", mesh);
    says("no such file");
    REQUIRE(mkfifo(mesh.c_str(), 0600) == 0);
    says("is no regular file, expected a mesh file");
}

TEST_CASE("Results without rows score 0", "[evaluate]") {
    Workspace const workspace;
    require_done(workspace.evaluate_text(header));
    CHECK_THAT(workspace.text("out/scores.csv"), Contains("\nwrong,all,0,4,8,0,"));
}

TEST_CASE("evaluate leaves out what is hidden, if told to", "[evaluate]") {
    Workspace const workspace;
    CommandResult const result = workspace.evaluate({"right.csv", "DATASET", "--visible-from", "0.6"});
    require_done(result);
    CHECK_THAT(result.out, Contains("6 instances in 4 images, each at least 60 % visible"));
    check_bad_input(workspace.evaluate({"right.csv", "DATASET", "--visible-from", "1.5"}), {"--visible-from"});
    std::filesystem::remove(workspace.dataset() / "test/000002/scene_gt_info.json");
    CommandResult const unknown = workspace.evaluate({"right.csv", "DATASET", "--visible-from", "0.6", "--out", "out"});
    require_done(unknown);
    CHECK_THAT(unknown.out, Contains("7 instances in 4 images, each at least 60 % visible (4 of unknown visibility)"));
    CHECK(nlohmann::json::parse(workspace.text("out/evaluation.json"))["of_unknown_visibility"] == 4);
}

TEST_CASE("evaluate says which depth images are missing, of another size or of another unit", "[evaluate]") {
    Workspace const workspace;
    std::filesystem::path const depths = workspace.dataset() / "test/000001/depth";
    auto const warned = [&] {
        CommandResult const result = workspace.evaluate({"right.csv", "DATASET"});
        require_done_with_warnings(result);
        return result.err;
    };
    workspace.dataset().replace("test/000001/scene_camera.json", "\"depth_scale\": 0.1", "\"depth_scale\": 1");
    CHECK_THAT(warned(), Contains("000001/depth/000000.png: all of its ") &&
                             Contains("depth_scale of scene_camera.json = 1 mm per count"));
    workspace.dataset().replace("test/000001/scene_camera.json", "\"depth_scale\": 1", "\"depth_scale\": 0.1");
    files::write_png(depths / "000003.png", Image<std::uint16_t>(24, 32));
    CHECK_THAT(warned(), Contains("000001/depth/000003.png: is 32 x 24 pixels, expected 64 x 48 as ") &&
                             Contains("000001/depth/000000.png of the same camera"));
    std::filesystem::remove(depths / "000003.png");
    CHECK_THAT(warned(),
               Contains("000001/depth/000003.png: no such file; 1 of 4 images have no depth image, so VSD and "
                        "AR are not known"));
}

TEST_CASE("A target of an object that there is not is told with the file of targets", "[evaluate]") {
    Workspace const workspace;
    workspace.dataset().replace("test_targets_bop19.json", "\"obj_id\": 1", "\"obj_id\": 3");
    check_bad_input(workspace.evaluate({"right.csv", "DATASET"}),
                    {"/test_targets_bop19.json: obj_id = 3, of which there is no ", "models/obj_000003.ply, expected"});
}

TEST_CASE("evaluate refuses what is wrong in one line, and writes nothing", "[evaluate]") {
    Workspace const workspace;
    std::string const row = "1,0,1,0.5,1 0 0 0 1 0 0 0 1,0 0 600,-1\n";
    check_bad_input(workspace.evaluate({"none.csv", "DATASET", "--out", "out"}), {"none.csv: no such file"});
    check_bad_input(workspace.evaluate({"right.csv", "none", "--out", "out"}), {"none: no such folder"});
    check_bad_input(workspace.evaluate_text("scene_id,im_id,object_id,score,R,t,time\n" + row),
                    {"wrong.csv:1: no column obj_id in the header"});
    check_bad_input(
        workspace.evaluate_text(header + "1,9,1,0.5,1 0 0 0 1 0 0 0 1,0 0 600,-1\n"),
        {"wrong.csv:2: scene_id, im_id, obj_id = 1, 9, 1, and no row of the 1 is of a target of", "such as 1, 0, 1"});
    check_bad_input(workspace.evaluate_text(header + "1,0,1,0.5,1 0 0 0 1 0 0 0 2,0 0 600,-1\n"),
                    {"wrong.csv:2: column R", "expected a rotation"});
    check_bad_input(workspace.evaluate_text(header + "1,0,1,nan,1 0 0 0 1 0 0 0 1,0 0 600,-1\n"),
                    {"wrong.csv:2: column score = nan, expected a finite number"});
    check_bad_input(workspace.evaluate({"right.csv", (workspace.work() / "right.csv").string(), "DATASET"}),
                    {"another file is called right as well"});
    std::filesystem::create_directory(workspace.work() / "mine");
    workspace.work().write("mine/note.txt", "keep");
    check_bad_input(workspace.evaluate({"right.csv", "DATASET", "--out", "mine"}), {"mine"});
    CHECK(workspace.text("mine/note.txt") == "keep");
    CHECK_FALSE(std::filesystem::exists(workspace.work() / "out"));
}

TEST_CASE("evaluate says what it mends, and what it leaves out", "[evaluate]") {
    Workspace const workspace;
    std::string const right = workspace.text("right.csv");
    std::filesystem::remove_all(workspace.dataset() / "test/000002");
    CommandResult const result = workspace.evaluate_text(right + "1,0,4,0.5,1 0 0 0 1 0 0 0 1,0 0 600,-1\n" +
                                                         "1,0,1,0.1,1.004 0 0 0 1 0 0 0 1,0 0 600,0.25\n");
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, Contains("4 instances in 2 images"));
    CHECK_THAT(result.err, Contains("warning: ") && Contains("4 of 8 targets are in images that are not at hand") &&
                               Contains("wrong.csv:6: scene_id, im_id, obj_id = 2, 0, 1, which ") &&
                               Contains("5 of 10 rows are left out") &&
                               Contains("wrong.csv: 1 of 10 matrices R are up to 0.00802 off a rotation"));
}

TEST_CASE("Meshes in metres beside a diameter in millimetres are refused, or read as metres", "[evaluate]") {
    Workspace const workspace;
    CommandResult const as_it_was = workspace.evaluate({"off.csv", "DATASET"});
    for (int const object : {BopFolder::box, BopFolder::cylinder}) {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
            "element face {}\nproperty list uchar int vertex_indices\nend_header\n";
        Mesh const mesh = BopFolder::mesh_of(object);
        text = fmt::format(text, mesh.vertices.size(), mesh.faces.size());
        for (Eigen::Vector3d const& v : mesh.vertices)
            text += fmt::format("{:.9f} {:.9f} {:.9f}\n", v.x(), v.y(), v.z());
        for (auto const& face : mesh.faces)
            text += fmt::format("3 {} {} {}\n", face[0], face[1], face[2]);
        workspace.dataset().write(fmt::format("models/obj_{:06}.ply", object), text);
    }
    check_bad_input(workspace.evaluate({"off.csv", "DATASET"}),
                    {"obj_000001.ply: is 0.06 x 0.04 x 0.1 mm", "models_info.json", "diameter 123.3", "--models-in m"});
    CommandResult const in_metres = workspace.evaluate({"off.csv", "DATASET", "--models-in", "m"});
    require_done(in_metres);
    for (CommandResult const& each : {as_it_was, in_metres})  // but for what rounding does to the last digit
        CHECK_THAT(each.out, Contains("| all | off | 8 | 8 | 77.4 (75.3 .. 79.4) | 73.7 (73.7 .. 73."));
    check_bad_input(workspace.evaluate({"off.csv", "DATASET", "--models-in", "cm"}), {"--models-in"});
}

TEST_CASE("A bootstrap of more draws than fit into memory is refused before any pose is judged", "[evaluate]") {
    if (is_instrumented)  // whose memory no limit allows
        return;
    Workspace const workspace;
    Words const words{"-c",        "ulimit -v 400000; exec \"$@\"",     "sh",           FASTER_SIM_BINARY, "evaluate",
                      "right.csv", workspace.dataset().path().string(), "--bootstraps", "1000000"};
    check_bad_input(run_command("/bin/sh", words, workspace.work().path()),
                    {"evaluate: would take about ", " GiB of memory, of which ", "evaluate --force"});
}

TEST_CASE("A dataset without true poses cannot be evaluated on", "[evaluate]") {
    Workspace const workspace;
    std::filesystem::remove(workspace.dataset() / "test_targets_bop19.json");
    for (std::string const scene : {"000001", "000002"})
        for (std::string const file : {"scene_gt.json", "scene_gt_info.json"})
            std::filesystem::remove(workspace.dataset() / ("test/" + scene + "/" + file));
    check_bad_input(workspace.evaluate({"right.csv", "DATASET"}), {"holds no true poses"});
}

}  // namespace evaluate_test
