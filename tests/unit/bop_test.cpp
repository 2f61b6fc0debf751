#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <regex>
#include <string>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"
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

/// Reads a dataset and asks for everything in it.
void use_all(fs::path const& folder, DatasetOptions const& options = {}) {
    Dataset const dataset = read_dataset(folder, options);
    for (auto const& [id, model] : dataset.models)
        sound(model);
    for (DatasetImage const& image : dataset.images) {
        for (GroundTruth const& object : sound(image).objects)
            sound(object);
    }
}

std::string complaint(BopFolder const& folder, DatasetOptions const& options = {}) {
    return complaint_in(folder.path(), [&] { use_all(folder.path(), options); });
}

struct ReadResults {
    std::vector<PoseEstimate> estimates;
    std::vector<std::string> warnings;
};

ReadResults read_results(fs::path const& file) {
    ReadResults read;
    read.estimates = read_pose_results(file, read.warnings);
    for (PoseEstimate const& estimate : read.estimates)
        sound(estimate);
    return read;
}

constexpr char const* results_header = "scene_id,im_id,obj_id,score,R,t,time\n";

std::string results_complaint(std::string const& rows) {
    TempFolder const folder;
    fs::path const file = folder.write("r.csv", results_header + rows);
    return complaint_in(folder.path(), [&] { read_results(file); });
}

std::vector<Detection> detections_of(fs::path const& file) {
    std::vector<std::string> warnings;
    std::vector<Detection> const detections = read_detections(file, warnings);
    CHECK(warnings.empty());
    return detections;
}

Mesh mesh_of_model(ObjectModel const& model) {
    std::vector<std::string> warnings;
    Mesh mesh = load_model(model, warnings);
    CHECK(warnings.empty());
    return mesh;
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
            workload::draw_mesh(mesh_of_model(dataset.models.at(object.obj_id)), object.pose, seen.camera, rendered);
        double largest = 0;
        for (std::size_t i = 0; i < rendered.pixels().size(); ++i)
            largest = std::max(largest, std::abs(rendered.pixels()[i] - seen.depth.pixels()[i]));
        CHECK(largest < 0.6e-4);  // half a count
    }
}

TEST_CASE("Meshes of a BOP folder are millimetres, and become metres", "[bop]") {
    BopFolder const folder;
    Dataset const dataset = read_dataset(folder.path());
    Mesh const mesh = mesh_of_model(dataset.models.at(1));
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

TEST_CASE("Of a link to a split, models and targets are those of the dataset that the split is in", "[bop]") {
    BopFolder const folder;
    TempFolder const elsewhere;
    fs::create_directory_symlink(folder / "test", elsewhere / "linked");
    CHECK(read_dataset(elsewhere / "linked").models.size() == 2);
    fs::create_directory_symlink(folder / "models", elsewhere / "models");
    fs::remove(folder / "test_targets_bop19.json");
    elsewhere.write("test_targets_bop19.json", "[]");
    CHECK(read_dataset(elsewhere / "linked").targets.size() == 8);  // its name is none of a test split
    fs::rename(elsewhere / "linked", elsewhere / "test");
    CHECK(read_dataset(elsewhere / "test").targets.empty());  // the models lie beside the link
}

TEST_CASE("A dataset without models names the folders that may be linked in their place", "[bop]") {
    BopFolder const folder;
    fs::rename(folder / "models", folder / "models_cad");
    CHECK_THAT(complaint(folder), Catch::Contains("models: no such folder, expected one with models, or a link of that "
                                                  "name to models_cad"));
    fs::create_directory_symlink("models_cad", folder / "models");
    CHECK(read_dataset(folder.path()).models.size() == 2);
}

TEST_CASE("Models are looked for in the folders asked for first", "[bop]") {
    BopFolder const folder;
    TempFolder const other;
    fs::copy(folder / "models/obj_000001.ply", other / "obj_000001.ply");
    other.write("models_info.json", R"({"1": {"diameter": 5}, "9": {"diameter": 1}})");
    Dataset const dataset = read_dataset(folder.path(), {"", {other.path()}, false});
    CHECK(dataset.models.at(1).diameter_m == Approx(0.005));
    CHECK(dataset.models.at(5).diameter_m == Approx(0.09434).epsilon(1e-4));
    fs::remove(other / "models_info.json");
    Dataset const told_by_own = read_dataset(folder.path(), {"", {other.path()}, false});
    CHECK(told_by_own.models.at(1).mesh == other / "obj_000001.ply");
    CHECK(told_by_own.models.at(1).diameter_m == Approx(0.12328828));
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
    SECTION("boxes, but no objects") {
        fs::remove(folder / "test/000001/scene_gt.json");
        CHECK(complaint(folder) == "test/000001/scene_gt.json: no such file, expected it beside scene_gt_info.json");
    }
    SECTION("no models_info.json") {
        fs::remove(folder / "models/models_info.json");
        CHECK_THAT(complaint(folder), Catch::Contains("models/models_info.json: no such file"));
    }
    SECTION("an object without information") {
        folder.replace("models/models_info.json", "\"5\"", "\"6\"");
        CHECK(complaint(folder) == "models/models_info.json: no key 5, expected one for obj_000005.ply");
    }
    SECTION("two folders of a scene") {
        fs::copy(folder / "test/000001", folder / "test/1", fs::copy_options::recursive);
        CHECK(complaint(folder) == "test/1: is scene 1, as 000001 is, expected one folder of a scene");
    }
    SECTION("two meshes of an object") {
        fs::copy(folder / "models/obj_000005.ply", folder / "models/obj_5.ply");
        CHECK(complaint(folder) ==
              "models/obj_5.ply: is object 5, as obj_000005.ply is, expected one mesh of an object");
    }
    SECTION("more than all of an object visible") {
        folder.replace("test/000001/scene_gt_info.json", "\"visib_fract\": 1", "\"visib_fract\": 1.5");
        CHECK_THAT(complaint(folder), Catch::Contains("visib_fract = 1.5, expected a share of the object, at most 1"));
    }
    SECTION("a symmetry that is none") {
        folder.replace("models/models_info.json", "[[-1, 0", "[[-2, 0");
        CHECK_THAT(complaint(folder), Catch::StartsWith("models/models_info.json: 1.symmetries_discrete[0] = an array "
                                                        "of 16, expected a rotation (R^T R differs"));
    }
    SECTION("a symmetry by columns") {
        folder.replace("models/models_info.json", "0, 0, 0, 0, 1, 0, 0, 0, 0, 1]]", "0, 0, 0, 0, 1, 0, 0, 0, 10, 1]]");
        CHECK(complaint(folder) ==
              "models/models_info.json: 1.symmetries_discrete[0] = an array of 16, expected "
              "0, 0, 0, 1 as its last row");
    }
    SECTION("cut off") {
        folder.replace("test/000001/scene_gt.json", "]\n}", "");
        CHECK_THAT(complaint(folder), Catch::StartsWith("test/000001/scene_gt.json:"));
        CHECK_THAT(complaint(folder), Catch::Contains("is cut off or no JSON from here on"));
    }
    SECTION("NaN") {
        folder.replace("test/000001/scene_gt.json", "\"cam_t_m2c\": [-60", "\"cam_t_m2c\": [NaN, -60");
        CHECK_THAT(complaint(folder),
                   Catch::Contains("scene_gt.json:2: NaN, which is no JSON, expected scene_gt.json"));
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
        folder.replace("test/000001/scene_gt_info.json", "\"3\"", "\"4\"");
        CHECK(complaint(folder) ==
              "test/000001/scene_gt.json: 4 = an array of 2, expected an image that scene_camera.json has, too");
    }
    SECTION("a camera with skew") {
        folder.replace("test/000002/scene_camera.json", "[60.0, 0.0", "[60.0, 0.5");
        CHECK(complaint(folder) ==
              "test/000002/scene_camera.json: 0.cam_K = an array of 9, expected a camera "
              "without skew, row by row: fx, 0, cx, 0, fy, cy, 0, 0, 1");
    }
    SECTION("a negative box") {
        folder.replace("test/000001/scene_gt_info.json", "[10, 12, 20", "[10, 12, -20");
        CHECK_THAT(complaint(folder), Catch::Contains("0[0].bbox_obj = an array of 4, expected a box"));
    }
    SECTION("fewer annotations than objects") {
        folder.replace("test/000001/scene_gt_info.json", "}, {", "} ], \"x\": [ {");
        CHECK(complaint(folder) ==
              "test/000001/scene_gt_info.json: 0 = an array of 1, expected an object for each that "
              "scene_gt.json has in this image");
    }
}

/// What all images but one say of themselves is read, whatever is wrong with that one.
void check_rest_is_read(BopFolder const& folder, std::string const& problem) {
    CHECK_THAT(complaint(folder), Catch::Contains(problem));
    Dataset const dataset = read_dataset(folder.path());
    CHECK(dataset.images.size() == 4);
    for (ImageId const id : {ImageId{1, 3}, ImageId{2, 0}, ImageId{2, 3}}) {
        for (GroundTruth const& object : sound(*dataset.find(id)).objects)
            sound(object);
    }
}

TEST_CASE("What is wrong with an image, an object or a model is nobody's business who does not ask for it", "[bop]") {
    BopFolder const folder;
    SECTION("no camera of the kind that is known") {
        folder.replace("test/000001/scene_camera.json", "cam_K", "cam_model");
        check_rest_is_read(folder, "scene_camera.json: 0: no key cam_K, expected one");
    }
    SECTION("no rotation") {
        folder.replace("test/000001/scene_gt.json", "\"cam_R_m2c\": [", "\"cam_R_m2c\": [9");
        check_rest_is_read(folder, "scene_gt.json: 0[0].cam_R_m2c");
    }
    SECTION("a box that is none") {
        folder.replace("test/000001/scene_gt_info.json", "[10, 12, 20", "[10, 12, -20");
        check_rest_is_read(folder, "scene_gt_info.json: 0[0].bbox_obj");
    }
    SECTION("a model without information") {
        folder.replace("models/models_info.json", "\"5\"", "\"6\"");
        Dataset const dataset = read_dataset(folder.path());
        CHECK(model_of(dataset, 1, "x").obj_id == 1);
        CHECK_THAT(input_error_text([&] { model_of(dataset, 5, "x"); }), Catch::Contains("no key 5, expected one"));
    }
}

TEST_CASE("A hidden object has no box, and is not to be seen", "[bop]") {
    BopFolder const folder;
    for (std::string const share : {"0", "0.0", "-1"}) {
        CAPTURE(share);
        folder.write("test/000001/scene_gt_info.json",
                     R"({"0": [{"bbox_obj": [-1, -1, -1, -1], "bbox_visib": [-1, -1, -1, -1], "visib_fract": )" +
                         share + R"(}, {"visib_fract": 0.75}]})");
        Dataset const dataset = read_dataset(folder.path());
        std::vector<GroundTruth> const& objects = sound(*dataset.find({1, 0})).objects;
        CHECK_FALSE(sound(objects[0]).box);
        CHECK_FALSE(objects[0].visible_box);
        CHECK(objects[0].is_hidden());
        CHECK(sound(objects[1]).visible_share == 0.75);
        CHECK_FALSE(objects[1].is_hidden());
        CHECK_FALSE(dataset.find({1, 3})->objects[0].visible_share);  // nothing is said of this image
    }
    std::string const nothing = "[-1, -1, -1, -1]", some = "[1, 2, 3, 4]";
    auto const is_hidden = [&](std::string const& boxes) {
        folder.write("test/000001/scene_gt_info.json", R"({"0": [{)" + boxes + "}, {}]}");
        return read_dataset(folder.path()).find({1, 0})->objects[0].is_hidden();
    };
    CHECK(is_hidden(R"("bbox_obj": )" + nothing));
    CHECK(is_hidden(R"("bbox_visib": )" + nothing + R"(, "bbox_obj": )" + some));
    CHECK_FALSE(is_hidden(R"("bbox_visib": )" + nothing + R"(, "visib_fract": 0.5)"));
    CHECK_FALSE(is_hidden(R"("bbox_visib": )" + some));
    CHECK_FALSE(is_hidden(""));
}

/// A rotation about x whose first column is longer by as much as makes R^T R differ from the identity by `off`.
std::string stretched(double off) {
    return fmt::format("[{:.12f}, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8]", std::sqrt(1 + off));
}

TEST_CASE("The nearest rotation is taken for a matrix that is a little off, and that is said once", "[bop]") {
    BopFolder const folder;
    auto const with_first = [&](double off) {
        folder.write("test/000002/scene_gt.json", R"({"0": [{"cam_R_m2c": )" + stretched(off) +
                                                      R"(, "cam_t_m2c": [0, 0, 600], "obj_id": 1}], "3": []})");
        std::filesystem::remove(folder / "test/000002/scene_gt_info.json");
        return read_dataset(folder.path());
    };
    Dataset const dataset = with_first(0.0094);
    Eigen::Matrix3d const& rotation = sound(dataset.find({2, 0})->objects[0]).pose.rotation;
    CHECK(rotation(0, 0) == Approx(1).margin(1e-12));
    CHECK(rotation(1, 2) == Approx(-0.6).margin(1e-12));
    REQUIRE(dataset.warnings.size() == 1);
    CHECK_THAT(dataset.warnings[0],
               Catch::Contains("scene_gt.json: 1 of 5 matrices R are up to 0.0094 off a rotation") &&
                   Catch::Contains("the nearest rotations are taken"));
    Dataset const rounded = with_first(0.0009);  // digits that were not written
    CHECK(rounded.warnings.empty());
    CHECK(rounded.find({2, 0})->objects[0].pose.rotation(0, 0) == Approx(std::sqrt(1.0009)).epsilon(1e-11));
    CHECK(with_first(0.0199).warnings.size() == 1);
    CHECK_THAT(
        input_error_text([&] {
            sound(with_first(0.0201).find({2, 0})->objects[0]);
        }),
        Catch::Contains("scene_gt.json: 0[0].cam_R_m2c = an array of 9, expected a rotation (R^T R differs from the "
                        "identity by 0.0201, at most 0.02)"));
}

TEST_CASE("The nearest rotation is the one whose entries differ least, and never mirrors", "[bop]") {
    Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        Eigen::Matrix3d const truth = BopFolder::pose_of(1, trial).rotation;
        Eigen::Matrix3d matrix = truth;
        for (Eigen::Index i = 0; i < 9; ++i)
            matrix(i) += 0.005 * (random.uniform() - 0.5);
        Eigen::Matrix3d const nearest = files::nearest_rotation(matrix);
        CHECK(files::distance_from_rotation(nearest) < 1e-14);
        CHECK(nearest.determinant() == Approx(1));
        double const distance = (nearest - matrix).norm();
        CHECK(distance <= (truth - matrix).norm());
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            for (double const angle : {-1e-4, 1e-4})
                CHECK(distance <= (Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)) * nearest - matrix).norm());
        }
    }
}

TEST_CASE("Targets in images that are not at hand are left out, and counted", "[bop]") {
    BopFolder const folder;
    folder.replace("test_targets_bop19.json", "\"im_id\": 3", "\"im_id\": 7");
    fs::remove_all(folder / "test/000002");
    Dataset const dataset = read_dataset(folder.path());
    CHECK(dataset.targets.size() == 3);
    REQUIRE(dataset.warnings_of_targets.size() == 1);
    CHECK(dataset.warnings_of_targets[0].find("5 of 8 targets are in images that are not at hand") !=
          std::string::npos);
    CHECK(dataset.images.size() == 2);
}

TEST_CASE("Targets of the challenge of 2024 are images, in which everything is to be found", "[bop]") {
    BopFolder const folder;
    folder.write("test_targets_bop24.json", R"([{"im_id": 3, "scene_id": 2}, {"im_id": 0, "scene_id": 9}])");
    CHECK(read_dataset(folder.path()).targets.size() == 8);  // the older file comes first
    fs::remove(folder / "test_targets_bop19.json");
    Dataset const dataset = read_dataset(folder.path());
    REQUIRE(dataset.targets.size() == 2);
    CHECK(dataset.targets[1].image == ImageId{2, 3});
    CHECK(dataset.targets[1].obj_id == 5);
    REQUIRE(dataset.warnings_of_targets.size() == 1);
    CHECK(dataset.warnings_of_targets[0].find("1 of 2 targets are in images that are not at hand") !=
          std::string::npos);
    folder.write("test_targets_bop24.json", R"([{"im_id": 0, "scene_id": 1, "obj_id": 5}])");
    REQUIRE(read_dataset(folder.path()).targets.size() == 1);
    CHECK(read_dataset(folder.path()).targets[0].inst_count == 1);
}

TEST_CASE("A target counts once, and is one even if nobody annotated it", "[bop]") {
    BopFolder const folder;
    folder.write("test_targets_bop19.json", R"([{"im_id": 0, "scene_id": 1, "obj_id": 5, "inst_count": 1},
        {"im_id": 0, "scene_id": 1, "obj_id": 7}, {"im_id": 0, "scene_id": 1, "obj_id": 5, "inst_count": 2}])");
    Dataset const dataset = read_dataset(folder.path());
    REQUIRE(dataset.targets.size() == 2);
    CHECK(dataset.targets[0].inst_count == 2);
    CHECK(dataset.targets[1].obj_id == 7);
    CHECK(dataset.targets[1].inst_count == 1);
    REQUIRE(dataset.warnings_of_targets.size() == 1);
    CHECK_THAT(dataset.warnings_of_targets[0], Catch::Contains("1 rows name a target that another row names"));
}

TEST_CASE("JSON as loaders of Python take it: rows in rows, remarks, whole numbers with a point", "[bop]") {
    BopFolder const folder;
    folder.write(
        "test/000001/scene_camera.json",
        R"({"remark": "by hand", "000000": {"cam_K": [[60, 0, 31], [0, 61, 23], [0, 0, 1]], "cam_t_w2c": [1, 2, 3]},
                     "3": {"cam_K": [60, 0, 31, 0, 61, 23, 0, 0, 1], "view_level": 2}})");
    folder.replace("test_targets_bop19.json", "\"im_id\": 0,", "\"im_id\": 0.0,");
    CHECK(complaint(folder) == "");
    Dataset const dataset = read_dataset(folder.path());
    CHECK(dataset.find({1, 0})->camera.fy == 61);
    CHECK(dataset.find({1, 0})->depth_unit_m == 0.001);
    folder.replace("test_targets_bop19.json", "\"im_id\": 0.0,", "\"im_id\": 0.5,");
    CHECK(complaint(folder) == "test_targets_bop19.json: [0].im_id = 0.5, expected an integer from 0");
    folder.write("test_targets_bop19.json", "[\n" + std::string(64, '[') + std::string(64, ']') + "]");
    CHECK(complaint(folder) ==
          "test_targets_bop19.json:2: has arrays and objects more than 64 deep, expected targets as BOP has them");
}

TEST_CASE("The size of an image is its own, whatever camera.json says of those to be rendered", "[bop]") {
    BopFolder const folder;
    folder.replace("camera.json", "\"height\": 48, \"width\": 64", "\"height\": 540, \"width\": 720");
    Dataset const dataset = read_dataset(folder.path());
    CHECK(load_observation(dataset.images[0]).camera.width == 64);
    folder.write("camera.json", R"({"fx": 1, "fy": 1, "cx": 1, "cy": 1})");
    CHECK(complaint(folder) == "");
}

/// A model of a dataset whose meshes are `scale` as large as its models_info.json says.
struct ScaledModels {
    explicit ScaledModels(double scale, std::string const& order = "xyz") {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
            "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
        for (Eigen::Vector3d const& corner :
             {Eigen::Vector3d(-30, -20, -50), Eigen::Vector3d(30, 20, 50), Eigen::Vector3d(30, -20, 50)}) {
            for (char const axis : order)
                text += fmt::format("{:.7f} ", scale * corner(axis - 'x'));
            text += "\n";
        }
        folder.write("models/obj_000001.ply", text + "3 0 1 2\n");
    }
    std::string complaint(DatasetOptions const& options = {}) {
        return complaint_in(folder.path(), [&] {
            Dataset const dataset = read_dataset(folder.path(), options);
            size_m = load_model(dataset.models.at(1), warnings).vertices[1].x() * 2;
        });
    }
    BopFolder folder;
    std::vector<std::string> warnings;
    double size_m = 0;
};

TEST_CASE("Meshes that contradict models_info.json are refused, with what would mend the unit", "[bop]") {
    ScaledModels in_metres(0.001);
    CHECK_THAT(
        in_metres.complaint(),
        Catch::StartsWith("models/obj_000001.ply: is 0.06 x 0.04 x 0.1 mm, of diameter 0.1233, but by ") &&
            Catch::Contains("models_info.json object 1 has diameter 123.3, and is 60 x 40 x 100 mm: 0.001 times") &&
            Catch::EndsWith("estimate and evaluate with --models-in m"));
    DatasetOptions options;
    options.unit_m = 1;
    CHECK(in_metres.complaint(options) == "");
    CHECK(in_metres.size_m == Approx(0.06));
    CHECK(in_metres.warnings.empty());
    CHECK_THAT(ScaledModels(1).complaint(options), Catch::Contains("1000 times") && Catch::EndsWith("--models-in mm"));
    CHECK_THAT(ScaledModels(25.4).complaint(), Catch::EndsWith("25.4 times as large, expected the same"));
    CHECK_THAT(ScaledModels(0.4).complaint(), Catch::Contains("0.4 times as large"));
}

TEST_CASE("A diameter that is not the mesh's is warned of or refused, even if the box could have it", "[bop]") {
    auto const complaint_and_warnings = [](std::string const& diameter) {
        ScaledModels models(1);
        models.folder.replace("models/models_info.json", "123.288280", diameter);
        std::string const complaint = models.complaint();
        return std::pair(complaint, models.warnings.size());
    };
    CHECK(complaint_and_warnings("115") == std::pair(std::string(), std::size_t{0}));
    CHECK(complaint_and_warnings("105") == std::pair(std::string(), std::size_t{1}));
    CHECK(complaint_and_warnings("160") == std::pair(std::string(), std::size_t{1}));
    CHECK_THAT(complaint_and_warnings("60").first,
               Catch::Contains("of diameter 123.3") && Catch::Contains("2.055 times as large"));
    CHECK_THAT(complaint_and_warnings("250").first, Catch::Contains("0.4932 times as large"));
}

TEST_CASE("A mesh that is somewhat different from models_info.json is warned of", "[bop]") {
    ScaledModels same(1.02), larger(1.3), turned(1, "yxz");
    for (ScaledModels* const models : {&same, &larger, &turned})
        CHECK(models->complaint() == "");
    CHECK(same.warnings.empty());
    REQUIRE(larger.warnings.size() == 1);
    CHECK_THAT(larger.warnings[0], Catch::Contains("is 78 x 52 x 130 mm") && Catch::Contains("is 60 x 40 x 100 mm"));
    REQUIRE(turned.warnings.size() == 1);
    CHECK_THAT(turned.warnings[0], Catch::Contains("is 40 x 60 x 100 mm") && Catch::Contains("other axes"));
}

TEST_CASE("True poses and depths of another unit are warned of", "[bop]") {
    BopFolder const folder;
    CHECK(read_dataset(folder.path()).warnings.empty());
    std::vector<std::string> warnings;
    auto const depths_of = [&](char const* scale) {
        folder.write("test/000001/scene_camera.json",
                     fmt::format(R"({{"0": {{"cam_K": [60, 0, 31, 0, 61, 23, 0, 0, 1], "depth_scale": {}}}}})", scale));
        Dataset const dataset = read_dataset(folder.path());
        warnings.clear();
        tell_of_depths(load_observation(*dataset.find({1, 0})), *dataset.find({1, 0}), warnings);
        return warnings.size();
    };
    CHECK(depths_of("0.1") == 0);
    REQUIRE(depths_of("1") == 1);
    CHECK_THAT(warnings[0], Catch::Contains("readings are beyond 3 m") &&
                                Catch::Contains("depth_scale of scene_camera.json = 1 mm per count"));
    REQUIRE(depths_of("0.01") == 1);
    CHECK_THAT(warnings[0], Catch::Contains("below 0.1 m"));
    for (std::string const scene : {"000001", "000002"})
        folder.write("test/" + scene + "/scene_gt.json",
                     R"({"0": [{"cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, 1], "cam_t_m2c": [0, 0, 0.6], "obj_id": 1}]})");
    REQUIRE(read_dataset(folder.path()).warnings.size() == 1);
    CHECK_THAT(read_dataset(folder.path()).warnings[0],
               Catch::Contains("cam_t_m2c puts half of the objects no farther than 0.6 mm"));
}

TEST_CASE("Results without a first line of names have BOP's columns", "[bop]") {
    TempFolder const folder;
    std::string const row = "48,1,5,0.25,1 0 0 0 1 0 0 0 1,1 2 3,1.5\n";
    auto const read = read_results(folder.write("r.csv", row + row));
    REQUIRE(read.estimates.size() == 2);
    CHECK(read.estimates[1].line == 2);
    CHECK(read.estimates[0].obj_id == 5);
    CHECK(read.estimates[0].pose.translation.z() == 0.003);
    CHECK(read.warnings.empty());
    auto const signs = read_results(folder.write("s.csv", "+48,+1,5,+0.25,+1 0 0 0 1 0 0 0 1,1 +2 3,+1.5\n"));
    CHECK(signs.estimates.at(0).image.scene_id == 48);
    CHECK(signs.estimates.at(0).pose.translation.y() == 0.002);
}

TEST_CASE("Rows of results are mended, refused for those who ask, and compared in time", "[bop]") {
    TempFolder const folder;
    std::string const good = "1,0,1,1,1 0 0 0 1 0 0 0 1,1 2 3,0.5\n";
    std::string const near = "1,0,1,1,1.0047 0 0 0 1 0 0 0 1,1 2 3,0.5\n",
                      far = "1,0,5,1,2 0 0 0 1 0 0 0 1,1 2 3,0.5\n";
    auto const read = read_results(folder.write("r.csv", results_header + good + near + near));
    CHECK(read.estimates[1].pose.rotation.isApprox(Eigen::Matrix3d::Identity(), 1e-12));
    REQUIRE(read.warnings.size() == 1);
    CHECK_THAT(read.warnings[0], Catch::Contains("r.csv: 2 of 3 matrices R are up to 0.00942 off a rotation"));
    std::vector<std::string> warnings;
    auto const rows = read_pose_results(folder.write("r.csv", results_header + good + far), warnings);
    CHECK(rows[0].problem.empty());
    CHECK_THAT(rows[1].problem, Catch::Contains("r.csv:3: column R = 2 0 0 0 1 0 0 0 1, expected a rotation"));
    auto const timed =
        read_results(folder.write("r.csv", results_header + good + "1,0,5,1,1 0 0 0 1 0 0 0 1,1 2 3,0.6\n"));
    REQUIRE(timed.warnings.size() == 1);
    CHECK_THAT(timed.warnings[0],
               Catch::Contains("r.csv:3: time = 0.6, expected 0.5 as in the rows before of image 0"));
}

TEST_CASE("A score that is no confidence from 0 to 1 is refused, one that is missing is said", "[bop]") {
    TempFolder const folder;
    auto const detection = [](std::string const& score) {
        return R"({"scene_id": 1, "image_id": 2, "category_id": 3, "bbox": [1.5, 2, 3, 4])" + score + "}";
    };
    fs::path const file =
        folder.write("d.json", "[" + detection(R"(, "score": 3)") + "," + detection(R"(, "score": -0.5)") + "," +
                                   detection(R"(, "time": null)") + "," + detection(R"(, "score": 1.0000001)") + "]");
    std::vector<std::string> warnings;
    auto const read = read_detections(file, warnings);
    CHECK_THAT(input_error_text([&] { sound(read[0]); }),
               Catch::Contains("[0].score = 3, expected a confidence from 0 to 1"));
    CHECK_THAT(input_error_text([&] { sound(read[1]); }),
               Catch::Contains("[1].score = -0.5, expected a confidence from 0 to 1"));
    CHECK(read[2].score == 1);
    CHECK(read[2].time_s == -1);
    CHECK(read[3].score == 1);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Contains("d.json: 1 of 4 detections have no score"));
    auto const odd = detections_of(folder.write("o.json", R"([{"scene_id": 1, "image_id": 2, "category_id": 3,
        "bbox": [-1, -1, -1, -1], "score": 0.5}, {"scene_id": 1, "image_id": 2, "category_id": 3, "score": 0.5}])"));
    CHECK_THAT(input_error_text([&] { sound(odd[0]); }), Catch::Contains("[0].bbox = an array of 4, expected a box"));
    CHECK_THAT(input_error_text([&] { sound(odd[1]); }), Catch::Contains("[1]: no key bbox, expected one"));
    auto const flat = detections_of(folder.write("f.json", R"([{"scene_id": 1, "image_id": 2, "category_id": 3,
        "bbox": [5, 5, 0, 9], "score": 0.5}])"));
    CHECK_THAT(input_error_text([&] { sound(flat[0]); }), Catch::Contains("expected a box of something seen"));
    CHECK(detections_of(folder.write("n.json", R"([{"scene_id": 1, "image_id": 2, "category_id": 0,
        "bbox": [5, 5, 9, 9], "score": 0.5}])"))
              .size() == 1);  // of nothing that the dataset has
}

TEST_CASE("Results that are written are read back", "[bop]") {
    TempFolder const folder;
    std::vector<PoseEstimate> estimates(2);
    estimates[0] = {{48, 1}, 5, 0.25, BopFolder::pose_of(5, 3), 1.5, 0, {}};
    estimates[1] = {{48, 36}, 2, -3e-7, BopFolder::pose_of(1, 0), -1, 0, {}};
    std::string const text = pose_results_csv(estimates);
    CHECK(text.rfind("scene_id,im_id,obj_id,score,R,t,time\n48,1,5,0.25,", 0) == 0);
    auto const back = read_results(folder.write("r.csv", text)).estimates;
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
    CHECK_THAT(input_error_text([&] { read_results(file); }), Catch::Contains("no column t in the header"));
    CHECK_THAT(input_error_text([&] { read_results(folder / "none.csv"); }), Catch::Contains("no such file"));
}

TEST_CASE("A file of results that is cut off anywhere is read or refused in one line", "[bop]") {
    TempFolder const folder;
    std::vector<PoseEstimate> const estimates{{{1, 2}, 3, 0.5, BopFolder::pose_of(1, 3), 0.25, 0, {}}};
    std::string const whole = pose_results_csv(estimates);
    std::size_t refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        fs::path const file = folder.write("r.csv", whole.substr(0, length));
        refused += complaint_in(folder.path(), [&] { read_results(file); }).empty() ? 0U : 1U;
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

TEST_CASE("Boxes of detections that are shares of the image's sides are warned of", "[bop]") {
    TempFolder const folder;
    auto const told = [&](char const* second) {
        std::vector<std::string> warnings;
        read_detections(
            folder.write(
                "d.json",
                fmt::format(
                    R"([{{"scene_id": 1, "image_id": 0, "category_id": 1, "bbox": [0.2, 0.3, 0.1, 0.7], )"
                    R"("score": 1}}, {{"scene_id": 1, "image_id": 0, "category_id": 1, "bbox": {}, "score": 1}}])",
                    second)),
            warnings);
        return warnings;
    };
    CHECK(told("[0.2, 0.3, 10, 7]").empty());
    REQUIRE(told("[0, 0, 1, 1]").size() == 1);
    CHECK_THAT(told("[0, 0, 1, 1]")[0],
               Catch::EndsWith("d.json: all boxes lie within 0 and 1, expected pixels, not shares of "
                               "the image's sides"));
}

TEST_CASE("Detections that are written are read back, and masks are skipped", "[bop]") {
    TempFolder const folder;
    std::vector<Detection> const detections{{{50, 4}, 2, {1.5, -2, 30, 40}, 0.968, 0.05, {}},
                                            {{51, 2}, 17, {}, 0.5, -1, {}}};
    auto const back = detections_of(folder.write("d.json", detections_json(detections)));
    REQUIRE(back.size() == 2);
    CHECK(back[0].image == ImageId{50, 4});
    CHECK(back[0].box.top == -2);
    CHECK(back[0].score == 0.968);
    CHECK(back[1].obj_id == 17);
    CHECK(back[1].time_s == -1);
    auto const masked = detections_of(
        folder.write("m.json", R"([{"scene_id": 1, "image_id": 2, "category_id": 3, "score": 0.5, "bbox": [1, 2, 3, 4],
                       "segmentation": {"counts": [1, 2], "size": [480, 640]}}])"));
    CHECK(masked[0].time_s == -1);
    CHECK_THAT(input_error_text([&] { detections_of(folder.write("b.json", R"([{"scene_id": 1}])")); }),
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

TEST_CASE("Frames are a dataset: their folder, the folder of these, and the one with the meshes", "[bop]") {
    TempFolder const data;
    std::string const frame = R"("width": 4, "height": 3, "depth": "d.png", "depth_unit_m": 0.001, )"
                              R"("intrinsics": {"fx": 5, "fy": 5, "cx": 1, "cy": 1}, "objects": [{"class": "b", )"
                              R"("R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "t_scan": [0, 0, 0.5]}]})";
    fs::create_directories(data / "depth/one");
    fs::create_directories(data / "depth/two");
    fs::create_directories(data / "meshes");
    data.write("depth/one/frames.json", R"({"frames": [{"id": "000007", )" + frame + "]}");
    data.write("depth/two/frames.json", R"({"frames": [{"id": "3", )" + frame + R"(, {"id": "4", )" + frame + "]}");
    for (std::string const name : {"a", "b"})
        data.write("meshes/" + name + ".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (std::string const name : {".", "depth", "depth/"}) {
        CAPTURE(name);
        Dataset const dataset = read_dataset(data / name);
        REQUIRE(dataset.images.size() == 3);
        CHECK(dataset.images[2].id == ImageId{2, 4});
        CHECK(dataset.images[2].objects.at(0).obj_id == 2);
        CHECK(dataset.models.size() == 2);
        CHECK(dataset.targets.size() == 3);
    }
    CHECK(read_dataset(data / "depth/two").images.at(1).id == ImageId{1, 4});
    fs::remove_all(data / "meshes");
    CHECK_THAT(complaint_in(data.path(), [&] { read_dataset(data / "depth"); }),
               Catch::StartsWith("meshes: no such folder"));
}

TEST_CASE("Frames of another unit are warned of, and two meshes of a class refused", "[bop]") {
    TempFolder const data;
    fs::create_directories(data / "depth/one");
    fs::create_directories(data / "meshes");
    auto const write = [&](char const* side, char const* z) {
        data.write("meshes/a.off", fmt::format("OFF\n3 1 0\n0 0 0\n{0} 0 0\n0 {0} 0\n3 0 1 2\n", side));
        data.write(
            "depth/one/frames.json",
            fmt::format(R"({{"frames": [{{"id": "1", "width": 4, "height": 3, "depth": "d.png", "depth_unit_m": 0.001,)"
                        R"("intrinsics": {{"fx": 5, "fy": 5, "cx": 1, "cy": 1}}, "objects": [{{"class": "a", )"
                        R"("R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "t_scan": [0, 0, {}]}}]}}]}})",
                        z));
    };
    auto const warnings = [&](DatasetOptions const& options = {}) {
        Dataset const dataset = read_dataset(data.path(), options);
        std::vector<std::string> told = dataset.warnings;
        load_model(dataset.models.at(1), told);
        return told;
    };
    write("0.1", "0.5");
    CHECK(warnings().empty());
    DatasetOptions in_mm;
    in_mm.unit_m = 0.001;
    REQUIRE(warnings(in_mm).size() == 1);
    CHECK_THAT(warnings(in_mm)[0],
               Catch::Contains("a.off: is 0.0001 m long; expected at least 0.005 m (read in millimetres"));
    write("100", "500");
    REQUIRE(warnings().size() == 2);
    CHECK_THAT(warnings()[0], Catch::Contains("frames.json: t_scan puts half of the objects farther than 500 m from"));
    CHECK_THAT(warnings()[1], Catch::Contains("a.off: is 100 m long, which looks like millimetres") &&
                                  Catch::Contains("(read in metres; --models-in"));
    fs::copy(data / "meshes/a.off", data / "meshes/a.obj");
    CHECK(complaint_in(data.path(), [&] { read_dataset(data.path()); }) ==
          "meshes/a.off: is a mesh of a, as a.obj is, expected one mesh of a class");
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
        workload::draw_mesh(mesh_of_model(dataset.models.at(object.obj_id)), object.pose, seen.camera, rendered);
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
