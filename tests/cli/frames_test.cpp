// Datasets of frames, as one takes them oneself: without annotation.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/bop_folder.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace frames_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

std::string off_of(faster::Mesh const& mesh) {
    std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.faces.size());
    for (Eigen::Vector3d const& v : mesh.vertices)
        text += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
    for (auto const& face : mesh.faces)
        text += fmt::format("3 {} {} {}\n", face[0], face[1], face[2]);
    return text;
}

/// Image 0 of BopFolder as a frame; objects 1 and 2 are its box and its cylinder.
class Frames {
  public:
    Frames() {
        BopFolder const dataset;
        std::filesystem::create_directories(folder_ / "depth/own");
        std::filesystem::create_directories(folder_ / "meshes");
        std::filesystem::copy(dataset / "test/000001/depth/000000.png", folder_ / "depth/own/d.png");
        folder_.write("meshes/a_box.off", off_of(BopFolder::mesh_of(BopFolder::box)));
        folder_.write("meshes/b_cylinder.off", off_of(BopFolder::mesh_of(BopFolder::cylinder)));
        folder_.write("config.yaml",
                      "accelerator: {window: 60}\nworkload: {samples: {count: 10}}\n"
                      "estimator: {iterations: 2}\n");
        write_frame("");
    }
    /// `objects`: the key, with a comma before it.
    void write_frame(std::string const& objects) const {
        folder_.write("depth/own/frames.json",
                      R"({"frames": [{"id": "0", "width": 64, "height": 48, "depth": "d.png", "depth_unit_m": 0.0001, )"
                      R"("intrinsics": {"fx": 60, "fy": 61, "cx": 31.5, "cy": 23.5})" +
                          objects + "}]}");
    }
    CommandResult estimate(Words words) const {
        words.insert(words.begin(), {"estimate", "config.yaml", "--untimed", "--bop", "."});
        return run_command(FASTER_SIM_BINARY, words, folder_.path());
    }
    TempFolder const& folder() const { return folder_; }

  private:
    TempFolder folder_;
};

TEST_CASE("What a detector saw in frames that nobody annotated is looked for", "[estimate][bop]") {
    Frames const frames;
    frames.folder().write(
        "boxes.json", R"([{"scene_id": 1, "image_id": 0, "category_id": 2, "bbox": [35, 15, 12, 16], "score": 0.9},)"
                      R"({"scene_id": 1, "image_id": 0, "category_id": 2, "bbox": [30, 15, 12, 16], "score": 0.5},)"
                      R"({"scene_id": 1, "image_id": 7, "category_id": 1, "bbox": [5, 15, 12, 16], "score": 0.9}])");
    for (std::string const objects : {"", R"(, "objects": [])"}) {
        CAPTURE(objects);
        frames.write_frame(objects);
        require_done(frames.estimate({"--scene", "1", "--object", "2", "--detections", "boxes.json"}));
        CommandResult const all = frames.estimate({"--all", "--detections", "boxes.json", "--out", "all"});
        require_done(all);
        CHECK_THAT(all.out, Contains("1 targets, 0 without a box; 1 estimates"));
        CHECK(lines_of(content_of(frames.folder() / "all/results.csv")).at(1).rfind("1,0,2,", 0) == 0);
        check_bad_input(frames.estimate({"--all", "--out", "none"}), {"has no targets, expected some", "frames.json"});
        std::filesystem::remove_all(frames.folder() / "all");
    }
}

TEST_CASE("A mesh of frames in millimetres is told, with a detector's boxes as well", "[estimate][bop]") {
    Frames const frames;
    faster::Mesh mesh = BopFolder::mesh_of(BopFolder::cylinder);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= 1000;
    frames.folder().write("meshes/b_cylinder.off", off_of(mesh));
    frames.folder().write(
        "boxes.json", R"([{"scene_id": 1, "image_id": 0, "category_id": 2, "bbox": [35, 15, 12, 16], "score": 0.9}])");
    for (Words words : {Words{"--scene", "1", "--object", "2"}, Words{"--all", "--out", "all"}}) {
        words.insert(words.end(), {"--detections", "boxes.json"});
        CommandResult const result = frames.estimate(words);
        require_done_with_warnings(result);
        CHECK_THAT(result.err, Contains("b_cylinder.off: is 80 m long, which looks like millimetres"));
    }
    require_done(frames.estimate({"--scene", "1", "--object", "2", "--detections", "boxes.json", "--models-in", "mm"}));
}

}  // namespace frames_test
