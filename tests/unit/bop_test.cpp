#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/scene_renderer.hpp"
#include "poses/bop/detections.hpp"
#include "poses/bop/pose_results.hpp"
#include "poses/bop/read_dataset.hpp"
#include "support/bop_folder.hpp"
#include "support/input_error_text.hpp"

namespace bop_test {

using namespace faster;
using namespace faster::bop;
using faster::test::BopFolder;
using faster::test::input_error_text;
using faster::test::TempFolder;
namespace fs = std::filesystem;

/// What an InputError says of a file of a folder, one line, without the folder's name; nothing if there is no error.
template <class Action> std::string complaint_in(fs::path const& folder, Action const& action) {
    std::string const text = input_error_text(action);
    CHECK(text.find('\n') == std::string::npos);
    std::string const prefix = folder.string() + "/";
    return text == "(no error)" ? "" : text.rfind(prefix, 0) == 0 ? text.substr(prefix.size()) : text;
}

std::string complaint(BopFolder const& folder, DatasetOptions const& options = {}) {
    return complaint_in(folder.path(), [&] { read_dataset(folder.path(), options); });
}

std::string results_complaint(std::string const& rows) {
    TempFolder const folder;
    fs::path const file = folder.write("r.csv", "scene_id,im_id,obj_id,score,R,t,time\n" + rows);
    return complaint_in(folder.path(), [&] { read_pose_results(file); });
}

TEST_CASE("A BOP folder is read whole: cameras, poses, boxes, models, symmetries and targets", "[bop]") {
    BopFolder const folder;
    Dataset const dataset = read_dataset(folder.path());
    REQUIRE(dataset.images.size() == 4);
    DatasetImage const& image = dataset.images[3];
    CHECK(image.id == ImageId{2, 3});
    CHECK(image.camera.width == 64);
    CHECK(image.camera.fy == 61);
    CHECK(image.camera.cx == 31.5);
    CHECK(image.depth_unit_m == Approx(1e-4));
    REQUIRE(image.objects.size() == 2);
    CHECK(image.objects[1].obj_id == BopFolder::cylinder);
    Pose const expected = BopFolder::pose_of(BopFolder::cylinder, 3);
    CHECK((image.objects[1].pose.rotation - expected.rotation).norm() < 1e-8);
    CHECK((image.objects[1].pose.translation - expected.translation).norm() < 1e-8);
    CHECK(image.objects[0].visible_share == 0.5);
    CHECK(image.objects[0].box->left == 10);
    CHECK(image.objects[0].visible_box->height == 8);

    REQUIRE(dataset.models.size() == 2);
    ObjectModel const& box = dataset.models.at(1);
    CHECK(*box.diameter_m == Approx(0.12328828));
    REQUIRE(box.symmetries.size() == 1);
    CHECK(box.symmetries[0].rotation(0, 0) == -1);
    ObjectModel const& cylinder = dataset.models.at(5);
    REQUIRE(cylinder.axes.size() == 1);
    CHECK(cylinder.axes[0].direction == Eigen::Vector3d::UnitZ());

    REQUIRE(dataset.targets.size() == 8);
    CHECK(dataset.targets[7].image == ImageId{2, 3});
    CHECK(dataset.targets[7].obj_id == 5);
    CHECK(dataset.find({1, 3})->id == ImageId{1, 3});
    CHECK(dataset.find({1, 2}) == nullptr);
}

TEST_CASE("What a BOP folder says of a depth image is what the renderer put there", "[bop]") {
    BopFolder const folder;
    Dataset const dataset = read_dataset(folder.path());
    for (DatasetImage const& image : dataset.images) {
        Observation const seen = load_observation(image);
        workload::DepthImage rendered(seen.camera.height, seen.camera.width);
        for (GroundTruth const& object : image.objects)
            workload::draw_mesh(load_model(dataset.models.at(object.obj_id)), object.pose, seen.camera, rendered);
        double largest = 0;
        for (std::size_t i = 0; i < rendered.pixels().size(); ++i)
            largest = std::max(largest, std::abs(rendered.pixels()[i] - seen.depth.pixels()[i]));
        CHECK(largest < 0.6e-4);  // half a count
    }
}

TEST_CASE("Meshes of a BOP folder are millimetres, and become metres", "[bop]") {
    BopFolder const folder;
    Dataset const dataset = read_dataset(folder.path());
    Mesh const mesh = load_model(dataset.models.at(1));
    double longest = 0;
    for (auto const& vertex : mesh.vertices)
        longest = std::max(longest, vertex.norm());
    CHECK(mesh.vertices.size() == 8);
    CHECK(longest == Approx(0.12328828 / 2));
}

TEST_CASE("A symmetry's translation is the last column of its matrix", "[bop]") {
    BopFolder const folder;
    folder.replace("models/models_info.json", "[-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0,",
                   "[-1, 0, 0, 7, 0, -1, 0, 8, 0, 0, 1, 9,");
    Eigen::Vector3d const translation = read_dataset(folder.path()).models.at(1).symmetries[0].translation;
    CHECK((translation - Eigen::Vector3d(0.007, 0.008, 0.009)).norm() < 1e-15);
}

TEST_CASE("A split, and a dataset without targets or camera file, are datasets", "[bop]") {
    BopFolder const folder;
    folder.replace("test_targets_bop19.json", "\"inst_count\": 1", "\"inst_count\": 2");
    for (std::string const name : {"test", "test/", "./test/.", "models/../test"})
        CHECK(read_dataset(folder / name).targets[0].inst_count == 2);  // of the file
    fs::remove(folder / "test_targets_bop19.json");
    fs::remove(folder / "camera.json");
    Dataset const dataset = read_dataset(folder.path());
    CHECK(dataset.targets.size() == 8);
    CHECK(dataset.images[0].camera.width == 0);
    CHECK(load_observation(dataset.images[0]).camera.width == 64);
    fs::rename(folder / "test", folder / "train");
    CHECK(read_dataset(folder.path()).images.size() == 4);
    CHECK(read_dataset(folder.path(), {"train", {}, false}).images.size() == 4);
    CHECK_THAT(complaint(folder, {"test", {}, false}),
               Catch::Contains("has no split test, expected --split with one of train"));
}

TEST_CASE("Models are looked for in the folders asked for first", "[bop]") {
    BopFolder const folder;
    TempFolder const other;
    fs::copy(folder / "models/obj_000001.ply", other / "obj_000001.ply");
    other.write("models_info.json", R"({"1": {"diameter": 5}, "9": {"diameter": 1}})");
    Dataset const dataset = read_dataset(folder.path(), {"", {other.path()}, false});
    CHECK(dataset.models.at(1).diameter_m == Approx(0.005));
    CHECK(dataset.models.at(5).diameter_m == Approx(0.09434).epsilon(1e-4));
    fs::copy(folder / "models", folder / "models_eval");
    CHECK(read_dataset(folder.path()).models.at(1).mesh.parent_path().filename() == "models");
    CHECK(read_dataset(folder.path(), {"", {}, true}).models.at(1).mesh.parent_path().filename() == "models_eval");
}

TEST_CASE("What is wrong with a BOP folder is one line that says where", "[bop]") {
    BopFolder const folder;
    SECTION("no dataset") {
        fs::remove_all(folder / "test");
        CHECK_THAT(complaint(folder), Catch::Contains("holds no scenes, expected a dataset of BOP"));
    }
    SECTION("no models") {
        fs::remove_all(folder / "models");
        CHECK_THAT(complaint(folder), Catch::Contains("models: no such folder, expected one with models"));
    }
    SECTION("no models_info.json") {
        fs::remove(folder / "models/models_info.json");
        CHECK_THAT(complaint(folder), Catch::Contains("models/models_info.json: no such file"));
    }
    SECTION("an object without information") {
        folder.replace("models/models_info.json", "\"5\"", "\"6\"");
        CHECK(complaint(folder) == "models/models_info.json: no key 5, expected one for obj_000005.ply");
    }
    SECTION("a symmetry that is none") {
        folder.replace("models/models_info.json", "[[-1, 0", "[[-2, 0");
        CHECK_THAT(complaint(folder), Catch::StartsWith("models/models_info.json: 1.symmetries_discrete[0] = an array "
                                                        "of 16, expected a rotation (R^T R differs"));
    }
    SECTION("cut off") {
        folder.replace("test/000001/scene_gt.json", "]\n}", "");
        CHECK_THAT(complaint(folder), Catch::StartsWith("test/000001/scene_gt.json:"));
        CHECK_THAT(complaint(folder), Catch::Contains("is cut off or no JSON from here on"));
    }
    SECTION("NaN") {
        folder.replace("test/000001/scene_gt.json", "\"cam_t_m2c\": [-60", "\"cam_t_m2c\": [NaN, -60");
        CHECK_THAT(complaint(folder), Catch::Contains("scene_gt.json:2: is cut off or no JSON from here on"));
    }
    SECTION("a misspelt key") {
        folder.replace("test/000002/scene_gt.json", "cam_R_m2c", "cam_R_mc");
        CHECK(complaint(folder) ==
              "test/000002/scene_gt.json: 0[0]: no key cam_R_m2c, expected one, did you mean cam_R_mc?");
    }
    SECTION("no rotation") {
        folder.replace("test/000001/scene_gt.json", "\"cam_R_m2c\": [", "\"cam_R_m2c\": [9");
        CHECK_THAT(complaint(folder), Catch::StartsWith("test/000001/scene_gt.json: 0[0].cam_R_m2c = an array of 9, "
                                                        "expected a rotation"));
    }
    SECTION("an object of no number") {
        folder.replace("test/000001/scene_gt.json", "\"obj_id\": 1", "\"obj_id\": 0");
        CHECK(complaint(folder) == "test/000001/scene_gt.json: 0[0].obj_id = 0, expected an integer from 1");
    }
    SECTION("an image without a camera") {
        folder.replace("test/000001/scene_gt.json", "\"3\"", "\"4\"");
        CHECK(complaint(folder) ==
              "test/000001/scene_gt.json: 4 = an array of 2, expected an image that scene_camera.json has, too");
    }
    SECTION("a negative box") {
        folder.replace("test/000001/scene_gt_info.json", "[10, 12, 20", "[10, 12, -20");
        CHECK_THAT(complaint(folder), Catch::Contains("0[0].bbox_obj = an array of 4, expected a box"));
    }
    SECTION("a target in no image") {
        folder.replace("test_targets_bop19.json", "\"im_id\": 3", "\"im_id\": 7");
        CHECK(complaint(folder) == "test_targets_bop19.json: [2].im_id = 7, expected an image of scene 1");
    }
}

TEST_CASE("Results that are written are read back", "[bop]") {
    TempFolder const folder;
    std::vector<PoseEstimate> estimates(2);
    estimates[0] = {{48, 1}, 5, 0.25, BopFolder::pose_of(5, 3), 1.5, 0};
    estimates[1] = {{48, 36}, 2, -3e-7, BopFolder::pose_of(1, 0), -1, 0};
    std::string const text = pose_results_csv(estimates);
    CHECK(text.rfind("scene_id,im_id,obj_id,score,R,t,time\n48,1,5,0.25,", 0) == 0);
    auto const back = read_pose_results(folder.write("r.csv", text));
    REQUIRE(back.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(back[i].image == estimates[i].image);
        CHECK(back[i].obj_id == estimates[i].obj_id);
        CHECK(back[i].score == estimates[i].score);
        CHECK(back[i].pose.rotation == estimates[i].pose.rotation);
        CHECK((back[i].pose.translation - estimates[i].pose.translation).norm() < 1e-15);
        CHECK(back[i].time_s == estimates[i].time_s);
        CHECK(back[i].line == i + 2);
    }
}

TEST_CASE("What is wrong with a file of results is one line that says where", "[bop]") {
    std::string const identity = "1 0 0 0 1 0 0 0 1";
    CHECK(results_complaint("1,0,1,1," + identity + ",1 2 3,-1\n").empty());
    CHECK(results_complaint("1,0,1,1," + identity + ",1 2 nan,-1\n") ==
          "r.csv:2: column t = 1 2 nan, expected 3 finite numbers parted by blanks");
    CHECK(results_complaint("1,0,1,1,1 0 0 0 1 0 0 0,1 2 3,-1\n") ==
          "r.csv:2: column R = 1 0 0 0 1 0 0 0, expected 9 numbers parted by blanks, not 8");
    CHECK_THAT(results_complaint("1,0,1,1,1 0 0 0 1 0 0 0 1.1,1 2 3,-1\n"),
               Catch::Contains("expected a rotation (R^T R differs from the identity by 0.21"));
    CHECK_THAT(results_complaint("1,0,1,1,1 0 0 0 1 0 0 0 -1,1 2 3,-1\n"), Catch::Contains("mirrors"));
    CHECK(results_complaint("1,x,1,1," + identity + ",1 2 3,-1\n") ==
          "r.csv:2: column im_id = x, expected an integer from 0");
    CHECK(results_complaint("1,0,1,inf," + identity + ",1 2 3,-1\n") ==
          "r.csv:2: column score = inf, expected a finite number");
    CHECK(results_complaint("1,0,1,1," + identity + ",1 2 3\n") == "r.csv:2: 6 cells, expected 7 as in the header");
    TempFolder const folder;
    fs::path const file = folder.write("r.csv", "scene_id,im_id,obj_id,score,R,T,time\n");
    CHECK_THAT(input_error_text([&] { read_pose_results(file); }), Catch::Contains("no column t in the header"));
    CHECK_THAT(input_error_text([&] { read_pose_results(folder / "none.csv"); }), Catch::Contains("no such file"));
}

TEST_CASE("A file of results that is cut off anywhere is read or refused in one line", "[bop]") {
    TempFolder const folder;
    std::vector<PoseEstimate> const estimates{{{1, 2}, 3, 0.5, BopFolder::pose_of(1, 3), 0.25, 0}};
    std::string const whole = pose_results_csv(estimates);
    std::size_t refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        fs::path const file = folder.write("r.csv", whole.substr(0, length));
        refused += complaint_in(folder.path(), [&] { read_pose_results(file); }).empty() ? 0U : 1U;
    }
    CHECK(refused > whole.size() - 12);  // a shorter number of seconds is one, too, and so is no row
}

TEST_CASE("Any value of a dataset may be of the wrong kind without more than a complaint", "[bop]") {
    auto const seed = static_cast<std::uint64_t>(GENERATE(1, 2));
    CAPTURE(seed);
    Random random(seed);
    auto const below = [&](std::size_t count) {
        return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
    };
    BopFolder const folder;
    std::vector<std::string> const files{"models/models_info.json",   "test/000001/scene_camera.json",
                                         "test/000001/scene_gt.json", "test/000001/scene_gt_info.json",
                                         "test_targets_bop19.json",   "camera.json"};
    std::vector<std::string> const wrong{"null", "\"x\"", "[]", "{}", "-1", "1e400", "1.5", "true", "1e300", "]", ""};
    std::regex const number("-?[0-9.]+");
    std::size_t refused = 0;
    for (int round = 0; round < 150; ++round) {
        std::string const& file = files[below(files.size())];
        std::string const whole = faster::test::content_of(folder / file);
        std::vector<std::smatch> numbers(std::sregex_iterator(whole.begin(), whole.end(), number), {});
        std::smatch const& chosen = numbers[below(numbers.size())];
        auto const place = static_cast<std::size_t>(chosen.position()),
                   length = static_cast<std::size_t>(chosen.length());
        folder.write(file, std::string(whole).replace(place, length, wrong[below(wrong.size())]));
        refused += complaint(folder).empty() ? 0U : 1U;
        folder.write(file, whole);
    }
    CHECK(refused > 75);
    CHECK(complaint(folder).empty());
}

TEST_CASE("Detections that are written are read back, and masks are skipped", "[bop]") {
    TempFolder const folder;
    std::vector<Detection> const detections{{{50, 4}, 2, {1.5, -2, 30, 40}, 0.968, 0.05}, {{51, 2}, 17, {}, 0.5, -1}};
    auto const back = read_detections(folder.write("d.json", detections_json(detections)));
    REQUIRE(back.size() == 2);
    CHECK(back[0].image == ImageId{50, 4});
    CHECK(back[0].box.top == -2);
    CHECK(back[0].score == 0.968);
    CHECK(back[1].obj_id == 17);
    CHECK(back[1].time_s == -1);
    auto const masked = read_detections(
        folder.write("m.json", R"([{"scene_id": 1, "image_id": 2, "category_id": 3, "score": 0.5, "bbox": [1, 2, 3, 4],
                       "segmentation": {"counts": [1, 2], "size": [480, 640]}}])"));
    CHECK(masked[0].time_s == -1);
    CHECK_THAT(input_error_text([&] { read_detections(folder.write("b.json", R"([{"scene_id": 1}])")); }),
               Catch::Contains("b.json: [0]: no key image_id, expected one"));
}

TEST_CASE("The box of an object is that of its projection", "[bop]") {
    Mesh mesh;
    mesh.vertices = {{-0.1, 0, 0}, {0.2, 0.1, 0}, {0, -0.05, 0}, {0, 0, -3}};  // the last one is behind the camera
    Pose pose;
    pose.translation = {0, 0, 2};
    ImageBox const box = projected_box(mesh, pose, {640, 480, 100, 200, 50, 60});
    CHECK(box.left == Approx(45));
    CHECK(box.width == Approx(15));
    CHECK(box.top == Approx(55));
    CHECK(box.height == Approx(15));
}

TEST_CASE("Real frames are a dataset: the rendered objects are where the camera saw them", "[bop][shared_data]") {
    char const* const data = std::getenv("FASTER_SHARED_DATA");
    if (data == nullptr) {
        WARN("skipped: FASTER_SHARED_DATA (folder with meshes/ and depth/) is not set");
        return;
    }
    Dataset const dataset = read_dataset(data);
    CHECK(dataset.models.size() == 21);
    CHECK(dataset.models.at(17).name == "037_scissors");  // as BOP numbers the objects of YCB-Video
    CHECK(dataset.images.size() == 18);
    std::vector<int> objects;
    for (GroundTruth const& object : dataset.find({1, 2})->objects)
        objects.push_back(object.obj_id);
    CHECK(objects == std::vector<int>{1, 3, 4, 12, 17});
    CHECK(read_dataset(fs::path(data) / "depth" / "ycbv_0000").images.size() == 10);

    DatasetImage const& image = *dataset.find({2, 1});  // 0000 of YCB-Video
    Observation const seen = load_observation(image);
    workload::DepthImage rendered(seen.camera.height, seen.camera.width);
    for (GroundTruth const& object : image.objects)
        workload::draw_mesh(load_model(dataset.models.at(object.obj_id)), object.pose, seen.camera, rendered);
    std::size_t pixels = 0, near = 0;
    for (std::size_t i = 0; i < rendered.pixels().size(); ++i) {
        bool const both = rendered.pixels()[i] > 0 && seen.depth.pixels()[i] > 0;
        pixels += both ? 1U : 0U;
        near += both && std::abs(rendered.pixels()[i] - seen.depth.pixels()[i]) < 0.01 ? 1U : 0U;
    }
    CAPTURE(pixels, near);
    CHECK(static_cast<double>(near) > 0.95 * static_cast<double>(pixels));
}

}  // namespace bop_test
