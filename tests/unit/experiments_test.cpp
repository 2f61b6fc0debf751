#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <set>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/held_signals.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/models/builtin_models.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/experiments/boxes_of_detector.hpp"
#include "poses/experiments/estimate_journal.hpp"
#include "poses/experiments/experiment_file.hpp"
#include "poses/experiments/made_dataset.hpp"
#include "poses/experiments/scene_meshes.hpp"
#include "poses/experiments/ycb_classes.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace experiments_test {

using namespace faster;
using namespace faster::experiments;
using faster::test::input_error_text;
using faster::test::TempFolder;

std::map<int, Mesh> const& all_meshes() {
    static std::map<int, Mesh> const meshes = [] {
        std::map<int, Mesh> made;
        for (std::string const& name : ycb_classes())
            made[obj_id_of(name)] = models::make(name);
        return made;
    }();
    return meshes;
}

MadeScene small_scene(std::uint64_t number, std::array<double, 2> visible) {
    return made_scene({5, visible, 77, number}, all_meshes(), {160, 120, 142.5, 142.5, 79.5, 59.5});
}

bop::Target const target{{1, 4}, 5, 1};
bop::ImageBox const true_box{100, 80, 40, 60};

constexpr char const* file_text =
    "format: faster-experiment\n"
    "version: 1\n"
    "seed: 6\n"
    "set: {workload.samples.count: 40}\n"
    "scenes:\n"
    "  hidden: {objects: [banana, mug], images: 2, visible: [0.3, 0.9], boxes: {shift: 0.1, wrong: 0.25}}\n"
    "  real: {dataset: frames}\n"
    "methods:\n"
    "  grip: {estimator.backend: grip}\n"
    "  faster: {}\n";

/// What is said of the file with `from` replaced.
std::string complaint_about(TempFolder const& folder, std::string const& from, std::string const& to) {
    std::string text = file_text;
    text.replace(text.find(from), from.size(), to);
    std::filesystem::create_directories(folder / "frames");
    folder.write("experiment.yaml", text);
    return input_error_text([&] { read_experiment_file(folder / "experiment.yaml"); });
}

TEST_CASE("Every class of YCB-Video is a built-in model, under its published number", "[experiments]") {
    CHECK(ycb_classes().size() == models::names().size());
    for (std::string const& name : ycb_classes())
        CHECK(models::contains(name));
    CHECK(obj_id_of("master_chef_can") == 1);
    CHECK(obj_id_of("foam_brick") == 21);
    CHECK(obj_id_of("teapot") == 0);
}

TEST_CASE("Symmetries of a class map its mesh to itself", "[experiments]") {
    for (auto const& [id, mesh] : all_meshes()) {
        bop::ObjectModel model;
        std::string const& name = ycb_classes()[static_cast<std::size_t>(id) - 1];
        add_symmetries(model, name);
        CAPTURE(name);
        Eigen::Vector3d low = mesh.vertices.front(), high = low;
        for (Eigen::Vector3d const& v : mesh.vertices) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        }
        for (Pose const& symmetry : model.symmetries)
            CHECK((symmetry.rotation.cwiseAbs() * (high + low)).norm() < 1e-3);  // about the middle
        if (!model.axes.empty())
            CHECK(high.x() - low.x() == Approx(high.y() - low.y()).margin(2e-3));
    }
}

TEST_CASE("A made scene has five to seven objects, and shows as much of the wanted one as it was told",
          "[experiments]") {
    for (std::uint64_t number = 0; number < 4; ++number) {
        CAPTURE(number);
        MadeScene const scene = small_scene(number, {0.5, 0.6});
        CHECK(scene.objects.size() >= 5);
        CHECK(scene.objects.size() <= 7);
        bop::GroundTruth const& wanted = scene.objects.front();
        CHECK(wanted.obj_id == 5);
        CHECK(*wanted.visible_share == Approx(0.55).margin(0.12));  // tries look at fewer pixels
        CHECK(wanted.box->left >= 0);
        CHECK(wanted.visible_box->width <= wanted.box->width);
        std::set<int> ids;
        for (bop::GroundTruth const& object : scene.objects)
            CHECK(ids.insert(object.obj_id).second);
        MadeScene const again = small_scene(number, {0.5, 0.6});
        CHECK(again.depth.pixels() == scene.depth.pixels());
        CHECK(again.objects.front().pose.rotation == wanted.pose.rotation);
    }
    CHECK(small_scene(0, {0.5, 0.6}).depth.pixels() != small_scene(1, {0.5, 0.6}).depth.pixels());
}

TEST_CASE("A detector that makes no errors sees the annotated box", "[experiments]") {
    auto const boxes = boxes_of_detector(target, 0, true_box, {{1, 2, 3, 4}}, {}, 3);
    REQUIRE(boxes.size() == 1);
    CHECK(boxes[0].box.left == Approx(100));
    CHECK(boxes[0].box.height == Approx(60));
    CHECK(boxes[0].obj_id == 5);
    CHECK(boxes[0].image == target.image);
    CHECK(boxes[0].score > 0.4);
    CHECK(boxes_of_detector(target, 0, true_box, {{1, 2, 3, 4}}, {}, 3)[0].score == boxes[0].score);
    CHECK(boxes_of_detector(target, 1, true_box, {{1, 2, 3, 4}}, {}, 3)[0].score != boxes[0].score);
}

TEST_CASE("A detector's boxes are shifted, scaled, missing and wrong as often and as far as its model says",
          "[experiments]") {
    DetectorModel const model{0.2, 0.1, 0.25, 0.4};
    constexpr int count = 4000;
    int missing = 0, wrong = 0;
    double shifts = 0, squares = 0, scales = 0;
    for (int seed = 0; seed < count; ++seed) {
        bool has_right = false;
        for (bop::Detection const& seen :
             boxes_of_detector(target, 0, true_box, {{600, 400, 8, 9}}, model, static_cast<std::uint64_t>(seed))) {
            if (seen.box.left > 400) {
                ++wrong;
                continue;
            }
            has_right = true;
            double const shift = (seen.box.left + seen.box.width / 2 - 120) / 40;
            shifts += shift;
            squares += shift * shift;
            scales += std::pow(std::log(seen.box.height / 60), 2);
        }
        missing += has_right ? 0 : 1;
    }
    double const right = count - missing;
    CHECK(missing == Approx(0.25 * count).margin(110));  // four deviations
    CHECK(wrong == Approx(0.4 * count).margin(125));
    CHECK(shifts / right == Approx(0).margin(0.015));
    CHECK(std::sqrt(squares / right) == Approx(0.2).margin(0.011));
    CHECK(std::sqrt(scales / right) == Approx(0.1).margin(0.006));
}

TEST_CASE("Made scenes are a dataset of BOP, and are made once", "[experiments][bop]") {
    TempFolder const folder;
    Setting setting;
    setting.objects = {"banana"};
    setting.images = 2;
    std::size_t told = 0;
    auto const make = [&](std::uint64_t seed) {
        make_dataset(folder / "made", setting, all_meshes(), seed, 2,
                     [&](std::size_t done, std::size_t) { told = done; });
    };
    make(1);
    CHECK(told == 2);
    bop::Dataset const dataset = bop::read_dataset(folder / "made");
    REQUIRE(dataset.targets.size() == 2);
    CHECK(dataset.targets[1].obj_id == 10);
    REQUIRE(dataset.images.size() == 2);
    CHECK(dataset.models.size() == 21);
    CHECK(dataset.models.at(2).symmetries.size() == 3);
    CHECK(dataset.models.at(4).axes.size() == 1);
    std::vector<std::string> warnings;
    Mesh const mesh = bop::load_model(dataset.models.at(10), warnings);
    CHECK(warnings.empty());
    CHECK(mesh.faces.size() == all_meshes().at(10).faces.size());
    MadeScene const scene = made_scene({10, setting.visible, 1, 1}, all_meshes(), {});
    bop::GroundTruth const& read = dataset.images[1].objects.front();
    CHECK((read.pose.translation - scene.objects.front().pose.translation).norm() < 1e-9);
    CHECK((read.pose.rotation - scene.objects.front().pose.rotation).norm() < 1e-9);
    CHECK(read.visible_share == scene.objects.front().visible_share);
    bop::Observation const seen = bop::load_observation(dataset.images[1]);
    for (std::size_t i = 0; i < scene.depth.pixels().size(); i += 97)
        CHECK(seen.depth.pixels()[i] == Approx(scene.depth.pixels()[i]).margin(5.1e-5));
    told = 0;
    make(1);
    CHECK(told == 0);
    make(2);
    CHECK(told == 2);
}

std::string obj_text(Mesh const& mesh) {
    std::string text;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        text += fmt::format("v {} {} {}\n", vertex.x(), vertex.y(), vertex.z());
    for (auto const& face : mesh.faces)
        text += fmt::format("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
    return text;
}

TEST_CASE("Scenes can be made from meshes of a folder", "[experiments][bop]") {
    TempFolder const folder;
    std::filesystem::create_directory(folder / "scans");
    Mesh banana = all_meshes().at(10), mug = all_meshes().at(14);
    for (Eigen::Vector3d& vertex : banana.vertices)
        vertex += Eigen::Vector3d(0.1, 0.2, -0.3);
    folder.write("scans/011_banana.obj", obj_text(banana));
    folder.write("scans/mug.obj", obj_text(mug));
    folder.write("scans/notes.txt", "");
    Setting setting;
    setting.models = folder / "scans";
    setting.objects = {"banana"};
    setting.images = 1;
    setting.visible = {0.95, 1};  // soon found
    std::size_t told = 0;
    std::vector<std::string> warnings;
    auto const make = [&] {
        warnings.clear();
        make_dataset(folder / "made", setting, scene_meshes(setting.models, 2, warnings), 1, 2,
                     [&](std::size_t done, std::size_t) { told = done; });
        CHECK(warnings.empty());
    };
    make();
    CHECK(told == 1);
    bop::Dataset const dataset = bop::read_dataset(folder / "made");
    REQUIRE(dataset.models.size() == 2);
    Eigen::AlignedBox3d box;
    for (Eigen::Vector3d const& vertex : bop::load_model(dataset.models.at(10), warnings).vertices)
        box.extend(vertex);
    CHECK(box.center().norm() < 1e-6);
    folder.write("scans/mug.obj", obj_text(banana));
    told = 0;
    make();
    CHECK(told == 1);  // other meshes, other scenes
    folder.write("scans/banana.obj", obj_text(banana));
    CHECK_THAT(input_error_text(make),
               Catch::Matchers::Contains(
                   "scans/banana.obj: is a mesh of banana, as 011_banana.obj is, expected one mesh of a class"));
    std::filesystem::remove(folder / "scans/banana.obj");
    setting.objects = {"bowl"};
    CHECK_THAT(input_error_text(make), Catch::Matchers::Contains("has no mesh of bowl, expected one called bowl.obj"));
    setting.models = folder / "made";
    CHECK_THAT(input_error_text(make), Catch::Matchers::Contains("has no mesh of a class"));
}

TEST_CASE("Meshes of made scenes that are larger than a scene, or look like millimetres, are told", "[experiments]") {
    TempFolder const folder;
    Mesh mug = all_meshes().at(14);
    auto const enlarge = [&](double factor) {
        for (Eigen::Vector3d& vertex : mug.vertices)
            vertex *= factor;
        folder.write("mug.obj", obj_text(mug));
    };
    std::vector<std::string> warnings;
    enlarge(10);
    scene_meshes(folder.path(), 1, warnings);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Matchers::Contains(" m long; expected less than 0.8 m, as scenes are made of"));
    warnings.clear();
    enlarge(100);
    scene_meshes(folder.path(), 1, warnings);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Matchers::Contains("mug.obj: is 1") &&
                                Catch::Matchers::Contains("looks like millimetres; expected less than 3 m, as scenes"));
}

TEST_CASE("A signal ends the making of a scene", "[experiments]") {
    processes::HeldSignals const held;
    std::raise(SIGINT);
    CHECK_THROWS_AS(small_scene(0, {0, 1}), processes::Interrupted);
    processes::forget_signal();
}

TEST_CASE("A journal of estimates gives back what it was given, but for damaged rows", "[experiments]") {
    TempFolder const folder;
    EstimateResult result;
    result.pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    result.pose.translation = {0.1, -0.2, 0.7000000000000001};
    result.weight = 0.8;
    result.truth_weight = 0.9;
    result.verdict = "weak";
    result.adds_mm = {12.5, 3};
    {
        EstimateJournal journal(folder / "journal");
        journal.append({{"a", result}});
        result.weight = 0.1;
        journal.append({{"b", result}});
    }
    std::string const text = io::read_file(folder / "journal");
    folder.write("journal", text.substr(0, text.size() - 5));
    EstimateJournal const journal(folder / "journal");
    CHECK(journal.damaged() == 1);
    CHECK(journal.find("b") == nullptr);
    REQUIRE(journal.find("a") != nullptr);
    CHECK(journal.find("a")->pose.translation == result.pose.translation);
    CHECK(journal.find("a")->pose.rotation == result.pose.rotation);
    CHECK(journal.find("a")->weight == 0.8);
    CHECK(journal.find("a")->adds_mm == result.adds_mm);
    CHECK(io::read_file(folder / "journal") == text.substr(0, text.find('\n') + 1));
}

TEST_CASE("An experiment file is read as it is meant", "[experiments]") {
    TempFolder const folder;
    folder.write("experiment.yaml", file_text);
    std::filesystem::create_directories(folder / "frames");
    Experiment const read = read_experiment_file(folder / "experiment.yaml");
    CHECK(read.seed == 6);
    REQUIRE(read.scenes.size() == 2);
    CHECK(read.scenes[0].objects == std::vector<std::string>{"banana", "mug"});
    CHECK(read.scenes[0].images == 2);
    CHECK(read.scenes[0].visible == std::array<double, 2>{0.3, 0.9});
    CHECK(read.scenes[0].boxes.wrong == 0.25);
    CHECK(read.scenes[1].dataset == folder / "frames");
    REQUIRE(read.methods.size() == 2);
    CHECK(read.methods[0].name == "grip");
    CHECK(read.methods[0].settings == std::vector<std::string>{"estimator.backend=grip"});
    CHECK(read.settings == std::vector<std::string>{"workload.samples.count=40"});
}

TEST_CASE("What is wrong with an experiment file is said with its line", "[experiments]") {
    TempFolder const folder;
    auto const says = [&](char const* from, char const* to, std::vector<std::string> const& words) {
        std::string const message = complaint_about(folder, from, to);
        for (std::string const& word : words)
            CHECK_THAT(message, Catch::Matchers::Contains(word));
    };
    says("version: 1", "version: 2", {":2: version = 2", "expected 1"});
    says("mug]", "mugg]", {":6: ", "mug"});
    says("dataset: frames", "dataset: frame", {":7: dataset = frame", "a folder that is there"});
    says("images: 2,", "images: 2, models: scans,", {":6: models = scans", "a folder that is there"});
    says("mug]", "banana]", {":6: ", "at most once"});
    CHECK_THAT(complaint_about(folder, "mug]", "banana]"), !Catch::Matchers::Contains("did you mean"));
    says("[banana, mug]", "banana", {":6: objects = banana", "a list of classes"});
    CHECK_THAT(complaint_about(folder, "[banana, mug]", "banana"), Catch::Matchers::EndsWith("[banana, mug]"));
    says("images: 2", "images: 0", {":6: ", "from 1 to"});
    says("[0.3, 0.9]", "[0.9, 0.3]", {":6: ", "the smaller share first"});
    says("shift:", "shfit:", {":6: ", "did you mean shift?"});
    says("estimator.backend", "estimator.backen", {":9: ", "estimator.backend"});
    says("  grip:", "  g/rip:", {":9: ", "is no name"});
    says("{dataset: frames}", "{dataset: frames, models: frames}", {":7: ", "models"});
    says("{dataset: frames}", "{dataset: frames, images: 3, objects: [mug]}", {":7: ", "either dataset, or objects"});
    for (std::string const key : {"images: 3", "objects: [mug]", "visible: [0, 1]", "models: frames"})
        says("{dataset: frames}", ("{dataset: frames, " + key + "}").c_str(),
             {":7: ", "has " + key.substr(0, key.find(':')) + ", expected none beside dataset"});
    says("mug]", "widget]", {":6: ", "others are looked for in a dataset only"});
    says("methods:", "method:", {":8: method", "did you mean methods?"});
}

TEST_CASE("The shipped experiments can be read", "[experiments]") {
    std::size_t files = 0;
    for (auto const& entry : std::filesystem::directory_iterator(FASTER_SOURCE_DIR "/configs/experiments")) {
        CAPTURE(entry.path());
        CHECK_FALSE(read_experiment_file(entry.path()).methods.empty());
        ++files;
    }
    CHECK(files >= 2);
}

}  // namespace experiments_test
