#include <catch2/catch.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <tiffio.h>

#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "poses/bop/read_dataset.hpp"
#include "support/bop_folder.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace estimate_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;
using Json = nlohmann::json;

void write_tiff(std::string const& path, faster::Image<std::uint16_t> image) {
    std::unique_ptr<TIFF, void (*)(TIFF*)> const file(TIFFOpen(path.c_str(), "w"), TIFFClose);
    REQUIRE(file != nullptr);
    TIFFSetField(file.get(), TIFFTAG_IMAGEWIDTH, image.width());
    TIFFSetField(file.get(), TIFFTAG_IMAGELENGTH, image.height());
    TIFFSetField(file.get(), TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(file.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file.get(), TIFFTAG_ROWSPERSTRIP, image.height());
    for (int row = 0; row < image.height(); ++row)
        REQUIRE(TIFFWriteScanline(file.get(), image.row(row), static_cast<std::uint32_t>(row)) == 1);
}

/// A soup can in a small image; an estimate of it takes a tenth of a second.
class Workspace {
  public:
    Workspace() {
        folder_.write("config.yaml",
                      "accelerator: {raster_cores: 2, window: 60}\n"
                      "workload:\n"
                      "  object: tomato_soup_can\n"
                      "  max_triangles: 300\n"
                      "  pose: {translation_m: [0, 0, 0.65], rotation_deg: [120, 0, 0]}\n"
                      "  camera: {width: 160, height: 120, fx: 140, fy: 140, cx: 79.5, cy: 59.5}\n"
                      "  samples: {count: 60}\n"
                      "estimator: {iterations: 6, weights: {least_drawn_px: 20}}\n");
    }
    CommandResult estimate(Words words) const {
        words.insert(words.begin(), {"estimate", "config.yaml"});
        return run_command(FASTER_SIM_BINARY, words, folder_.path());
    }
    CommandResult run(Words const& words) const { return run_command(FASTER_SIM_BINARY, words, folder_.path()); }
    std::string text(std::string const& name) const { return content_of(folder_ / name); }
    Json json(std::string const& name) const { return Json::parse(text(name)); }
    bool has(std::string const& name) const { return std::filesystem::exists(folder_ / name); }

  private:
    TempFolder folder_;
};

/// A detection of an object of BopFolder, where it is in image 0 of scene 1.
std::string true_box(int object) {
    faster::bop::ImageBox const box =
        faster::bop::projected_box(BopFolder::mesh_of(object), BopFolder::pose_of(object, 0), BopFolder::camera());
    return R"([{"scene_id": 1, "image_id": 0, "category_id": )" + std::to_string(object) + R"(, "bbox": [)" +
           std::to_string(box.left) + "," + std::to_string(box.top) + "," + std::to_string(box.width) + "," +
           std::to_string(box.height) + R"(], "score": 0.9}])";
}

TEST_CASE("estimate finds the object, and tells how it got there", "[estimate]") {
    Workspace const workspace;
    CommandResult const result =
        workspace.estimate({"--untimed", "--out", "out", "--set", "estimator.iterations=25", "--set",
                            "workload.samples.count=200", "--set", "estimator.seed=1"});
    require_done(result);
    CHECK_THAT(result.out, Contains("Found") && Contains("ADD-S") && Contains("25 iterations of 200 samples"));
    Json const found = workspace.json("out/estimate.json");
    CHECK(found["format"] == "faster-estimate");
    CHECK(found["verdict"] == "found");
    CHECK(found["adds_mm"].get<double>() < 15);
    CHECK(found["add_mm"].get<double>() >= found["adds_mm"].get<double>());
    CHECK(found["total_ms"].is_null());
    CHECK(found["configuration"]["estimator.iterations"] == 25);
    REQUIRE(found["iterations"].size() == 25);
    CHECK(found["iterations"][24]["best_weight"] == found["weight"]);
    Words const rows = lines_of(workspace.text("out/iterations.csv"));
    REQUIRE(rows.size() == 26);
    CHECK(cells_of(rows[0]).size() == 18);
    double weight = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        Words const row = cells_of(rows[i]);
        REQUIRE(row.size() == 18);
        CHECK(std::stod(row[2]) >= weight);
        CHECK(std::stod(row[4]) <= 200);
        CHECK(row[11].empty());  // cycles
        weight = std::stod(row[2]);
    }
    for (char const* const picture : {"iteration_0000", "iteration_0001", "iteration_0024", "convergence", "course"})
        CHECK(workspace.has(std::string("out/images/") + picture + ".png"));
}

TEST_CASE("An estimate has the same bytes whatever the number of threads, and others with another seed", "[estimate]") {
    Workspace const workspace;
    for (char const* const backend : {"accelerator", "grip"}) {
        CAPTURE(backend);
        Words const common{"--untimed", "--backend", backend};
        for (auto const& [folder, jobs] : {std::pair{"one", "1"}, {"three", "3"}, {"eight", "8"}}) {
            Words words = common;
            words.insert(words.end(), {"-j", jobs, "--out", folder});
            require_done(workspace.estimate(words));
        }
        for (char const* const other : {"three", "eight"})
            for (char const* const file : {"/estimate.json", "/iterations.csv", "/images/convergence.png"})
                CHECK(workspace.text(std::string("one") + file) == workspace.text(other + std::string(file)));
        require_done(
            workspace.estimate({"--untimed", "--backend", backend, "--set", "estimator.seed=4", "--out", "x"}));
        CHECK(workspace.text("one/iterations.csv") != workspace.text("x/iterations.csv"));
    }
}

TEST_CASE("estimate escapes what a terminal would obey in the name of its folder", "[estimate]") {
    Workspace const workspace;
    CommandResult const result = workspace.estimate({"--untimed", "--out", "o\x1B", "--set", "estimator.iterations=1"});
    require_done(result);
    CHECK_THAT(result.out, Contains("written: o\\x1b\n"));
}

TEST_CASE("On one host core an estimate scores by the simulation itself, with the same bytes", "[estimate]") {
    Workspace const workspace;
    for (char const* const kind : {"best", "mean"}) {
        CAPTURE(kind);
        for (char const* const jobs : {"1", "3"})
            require_done(
                workspace.estimate({"-j", jobs, "--out", jobs, "--set", std::string("estimator.estimate=") + kind}));
        for (char const* const file : {"/estimate.json", "/iterations.csv", "/images/convergence.png"})
            CHECK(workspace.text(std::string("1") + file) == workspace.text(std::string("3") + file));
        CHECK(workspace.json("1/estimate.json")["iterations"][5]["cycles"].get<double>() > 0);
    }
}

TEST_CASE("An iteration takes the cycles of a run of its samples, and the host's time besides", "[estimate]") {
    Workspace const workspace;
    require_done(
        workspace.estimate({"--out", "out", "--set", "estimator.iterations=3", "--traces", "0,2", "-j", "2", "--set",
                            "host.start_us=100", "--set", "host.collect_us=200", "--set", "host.resample_us=700"}));
    Json const found = workspace.json("out/estimate.json");
    double total = 0;
    for (int k : {0, 1, 2}) {
        Json const& iteration = found["iterations"][static_cast<std::size_t>(k)];
        double const cycles = iteration["cycles"].get<double>();
        CHECK(iteration["accelerator_ms"].get<double>() == Approx(cycles / 200e3));
        CHECK(iteration["iteration_ms"].get<double>() == Approx(cycles / 200e3 + 1));
        total += iteration["iteration_ms"].get<double>();
        if (k == 1)
            continue;
        std::string const trace = "out/traces/iteration_000" + std::to_string(k);
        require_done(workspace.run({"run", "config.yaml", "--trace", trace, "--out", "run"}));
        Json const summary = workspace.json("run/summary.json");
        CHECK(summary["total_cycles"] == iteration["cycles"]);
        for (char const* const bound : {"low", "typical", "high"}) {
            auto const of_run = [&](char const* key) { return summary["power"][key][bound].get<double>(); };
            CHECK(iteration["energy_mj"][bound].get<double>() ==
                  Approx(of_run("energy_mj") + (of_run("static_w") + of_run("ps_w")) * 1));  // a millisecond of host
        }
    }
    CHECK(found["total_ms"].get<double>() == Approx(total));
    CHECK(found["total_mj"]["typical"].get<double>() ==
          Approx(found["iterations"][0]["energy_mj"]["typical"].get<double>() +
                 found["iterations"][1]["energy_mj"]["typical"].get<double>() +
                 found["iterations"][2]["energy_mj"]["typical"].get<double>()));
    CHECK_FALSE(workspace.has("out/traces/iteration_0001"));
    // The loop goes by the same counters, timed or not.
    require_done(workspace.estimate({"--out", "untimed", "--set", "estimator.iterations=3", "--untimed"}));
    CHECK(workspace.json("untimed/estimate.json")["pose"] == found["pose"]);
}

TEST_CASE("Any iteration of an estimate can be recorded", "[estimate]") {
    Workspace const workspace;
    Words const common{"--set", "estimator.iterations=3", "--out", "out", "--iteration"};
    auto const record = [&](Words words) {
        words.insert(words.begin(), common.begin(), common.end());
        return workspace.estimate(words);
    };
    require_done(record({"2", "--events", "two.events", "--vcd", "two.vcd", "--vcd-samples", "5"}));
    CHECK(workspace.has("two.gtkw"));
    CHECK_THAT(workspace.text("two.vcd"), Contains("rasterizer"));
    require_done(workspace.run({"whatif", "two.events", "--out", "again"}));
    CHECK(workspace.json("again/summary.json")["total_cycles"] ==
          workspace.json("out/estimate.json")["iterations"][2]["cycles"]);
    check_bad_input(record({"2", "--events", "x.events", "--untimed"}), {"--events", "--untimed"});
    check_bad_input(record({"2", "--events", "config.yaml/x.events"}), {"config.yaml/x.events"});
    check_bad_input(record({"3", "--timeline", "x.json"}), {"--iteration 3", "3 iterations"});
    CHECK_FALSE(workspace.has("x.events"));
}

TEST_CASE("estimate scores with any design, and with grip without cycles", "[estimate]") {
    Workspace const workspace;
    for (char const* const setting : {"accelerator.architecture=next", "accelerator.architecture=fpga_grip",
                                      "accelerator.architecture=threshold"}) {
        CAPTURE(setting);
        require_done(workspace.estimate({"--set", setting, "--set", "estimator.iterations=2", "--out", "out"}));
        CHECK(workspace.json("out/estimate.json")["iterations"][1]["cycles"].get<double>() > 1000);
    }
    require_done(workspace.estimate({"--backend", "grip", "--out", "grip"}));
    CHECK(workspace.json("grip/estimate.json")["scorer"] == "grip");
    CHECK(workspace.json("grip/estimate.json")["total_ms"].is_null());
}

TEST_CASE("An object of a dataset is looked for in its boxes, and its pose is a result of BOP", "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    Words const common{"--untimed",
                       "--bop",
                       dataset.path().string(),
                       "--scene",
                       "1",
                       "--set",
                       "estimator.iterations=25",
                       "--set",
                       "workload.samples.count=300",
                       "--set",
                       "estimator.weights.least_drawn_px=5"};
    auto const estimate = [&](Words more, char const* image = "0") {
        more.insert(more.end(), {"--image", image});
        more.insert(more.begin(), common.begin(), common.end());
        return workspace.estimate(more);
    };
    SECTION("in the box that is theirs they are found") {
        for (int const object : {BopFolder::box, BopFolder::cylinder}) {
            std::string const number = std::to_string(object);
            CAPTURE(number);
            dataset.write("true.json", true_box(object));
            require_done(
                estimate({"--object", number, "--detections", (dataset / "true.json").string(), "--out", number}));
            CHECK(workspace.json(number + "/estimate.json")["adds_mm"].get<double>() < 25);
            CHECK(lines_of(workspace.text(number + "/bop.csv"))[1].rfind("1,0," + number + ",", 0) == 0);
            require_done(workspace.run({"evaluate", number + "/bop.csv", dataset.path().string(), "--out", "judged"}));
            CHECK_THAT(workspace.text("judged/errors.csv"), Contains("bop,1,0," + number + ","));
        }
    }
    SECTION("annotated boxes of what is visible, without a detector's") {
        require_done(estimate({"--object", "1", "--out", "out"}));
        CHECK(workspace.json("out/estimate.json")["boxes"] ==
              Json::parse(R"([{"left": 11, "top": 13, "width": 9, "height": 8, "confidence": 1}])"));
    }
    SECTION("boxes of a detector, of this object in this image only") {
        dataset.write("boxes.json",
                      R"([{"scene_id": 1, "image_id": 0, "category_id": 5, "bbox": [2, 3, 20, 30], "score": 0.75},)"
                      R"({"scene_id": 1, "image_id": 0, "category_id": 5, "bbox": [9, 9, 9, 9], "score": 0.25},)"
                      R"({"scene_id": 1, "image_id": 3, "category_id": 5, "bbox": [1, 1, 9, 9], "score": 0.5}])");
        std::string const boxes = (dataset / "boxes.json").string();
        require_done(estimate({"--object", "5", "--detections", boxes, "--out", "out"}));
        Json const found = workspace.json("out/estimate.json");
        REQUIRE(found["boxes"].size() == 2);
        CHECK(found["boxes"][0]["confidence"] == 0.75);
        CHECK(found["boxes"][0]["height"] == 30);
        CommandResult const undetected = estimate({"--object", "1", "--detections", boxes, "--out", "out"});
        require_done_with_warnings(undetected);
        CHECK_THAT(undetected.err, Contains("boxes.json: has no box of object 1 in image 0 of scene 1, which is looked "
                                            "for in the whole image"));
        CHECK(workspace.json("out/estimate.json")["boxes"].empty());
        dataset.replace("boxes.json", "[9, 9, 9, 9]", "[90, 9, 9, 9]");
        check_bad_input(estimate({"--object", "5", "--detections", boxes}),
                        {"boxes.json", "overlaps the image of 64 x 48"});
    }
    SECTION("a hidden object has no box, and what is wrong elsewhere is no matter") {
        dataset.replace("test/000001/scene_gt_info.json", R"("bbox_visib": [11, 13, 9, 8])",
                        R"("bbox_visib": [-1, -1, -1, -1])");
        dataset.replace("test/000001/scene_gt_info.json", R"("visib_fract": 1)", R"("visib_fract": 0.0)");
        dataset.replace("test/000002/scene_gt.json", R"("cam_R_m2c": [)", R"("cam_R_m2c": [9)");
        dataset.replace("test_targets_bop19.json", R"("scene_id": 2)", R"("scene_id": 7)");
        CommandResult const hidden = estimate({"--object", "1", "--out", "out"});
        require_done_with_warnings(hidden);
        CHECK_THAT(hidden.err, Contains(dataset.path().string() + ": has no box of object 1 in image 0 of scene 1"));
        CHECK(workspace.json("out/estimate.json")["boxes"].empty());
        check_bad_input(workspace.estimate({"--untimed", "--bop", dataset.path().string(), "--scene", "2", "--image",
                                            "0", "--object", "1"}),
                        {"scene_gt.json: 0[0].cam_R_m2c"});
    }
    SECTION("boxes of what is not seen are enough to hide an object") {
        dataset.replace("test/000001/scene_gt_info.json",
                        R"("bbox_obj": [10, 12, 20, 22], "bbox_visib": [11, 13, 9, 8])",
                        R"("bbox_obj": [-1, -1, -1, -1], "bbox_visib": [-1, -1, -1, -1])");
        dataset.replace("test/000001/scene_gt_info.json", R"("visib_fract": 1)", R"("of_others": 1)");
        require_done_with_warnings(estimate({"--object", "1", "--out", "out"}));
        CHECK(workspace.json("out/estimate.json")["boxes"].empty());
    }
    SECTION("a split of several") {
        std::filesystem::rename(dataset / "test", dataset / "test_a");
        std::filesystem::copy(dataset / "test_a", dataset / "val", std::filesystem::copy_options::recursive);
        check_bad_input(estimate({"--object", "1"}), {"has no split test", "a split's folder", "test_a, val"});
        check_bad_input(estimate({"--object", "1", "--split", "b"}), {"has no split b", "--split with one of"});
        require_done(estimate({"--object", "1", "--split", "val"}));
        require_done(workspace.run(
            {"estimate", "config.yaml", "--untimed", "--bop", (dataset / "val").string(), "--all", "--out", "all"}));
        check_bad_input(workspace.run({"estimate", "config.yaml", "--bop", (dataset / "val").string(), "--all", "--out",
                                       "none", "--set", "workload.samples.poses=p.csv"}),
                        {"workload.samples.poses"});
        CHECK_FALSE(workspace.has("none"));
    }
    SECTION("of several instances the nearest is the truth") {
        dataset.add_cylinder(0.1);
        std::filesystem::remove(dataset / "test_targets_bop19.json");  // all that is annotated is to be found
        dataset.write("true.json", true_box(5));
        require_done(estimate({"--object", "5", "--detections", (dataset / "true.json").string(), "--out", "two"}));
        Json const found = workspace.json("two/estimate.json");
        CHECK(found["adds_mm"].get<double>() < 25);
        CHECK(found["truth"]["translation_m"][0].get<double>() == Approx(0.07));
        require_done(workspace.run({"evaluate", "two/bop.csv", dataset.path().string(), "--out", "judged"}));
        CHECK_THAT(workspace.text("judged/errors.csv"),
                   Contains(fmt::format(",{:.6f},", found["adds_mm"].get<double>() / 1000)));
    }
    SECTION("depth as TIFF, of another unit, and a confidence of 3, are said") {
        std::string const depth = (dataset / "test/000001/depth/000000").string();
        CommandResult const as_png = estimate({"--object", "1"});
        write_tiff(depth + ".tif", faster::files::read_png16(depth + ".png"));
        std::filesystem::remove(depth + ".png");
        CommandResult const as_tiff = estimate({"--object", "1"});
        require_done(as_tiff);
        CHECK(as_tiff.out == as_png.out);
        CHECK(as_tiff.err == "");
        dataset.replace("test/000001/scene_camera.json", R"("depth_scale": 0.1)", R"("depth_scale": 1)");
        CommandResult const odd = estimate({"--object", "1"});
        CHECK(odd.exit_code == 0);
        CHECK_THAT(odd.err, Contains("000000.tif: all of its ") && Contains("depth_scale of scene_camera.json = 1 mm"));
        std::string box = true_box(1);
        dataset.write("boxes.json", std::regex_replace(box, std::regex(R"("score": *[0-9.]+)"), R"("score": 3)"));
        check_bad_input(estimate({"--object", "1", "--detections", (dataset / "boxes.json").string()}),
                        {"boxes.json", ".score = 3, expected a confidence from 0 to 1"});
    }
    SECTION("keys of the command line that the dataset tells itself") {
        auto const check_idle = [](CommandResult const& result, std::string const& setting) {
            require_done_with_warnings(result);
            CHECK_THAT(result.err, Contains("--set " + setting + ": has no effect, as a dataset tells it itself"));
        };
        for (std::string const setting : {"estimator.box.left=3", "workload.camera.fx=70", "workload.object=mug",
                                          "workload.pose.rotation_deg=[0,0,1]", "workload.scene.depth_unit_m=0.001",
                                          "workload.mesh_files.scale=0.001"})
            check_idle(estimate({"--object", "1", "--set", setting}), setting);
        require_done(estimate(
            {"--object", "1", "--set", "workload.scene.downscale=2", "--set", "estimator.box.confidence=0.5"}));
        check_idle(workspace.estimate(
                       {"--bop", dataset.path().string(), "--all", "--out", "all", "--set", "workload.object=mug"}),
                   "workload.object=mug");
    }
    SECTION("what the dataset does not have") {
        check_bad_input(estimate({"--object", "2"}),
                        {"--object: obj_id = 2, of which there is no ", "models/obj_000002.ply, expected", "1, 5"});
        check_bad_input(estimate({"--object", "1"}, "7"), {"--image 7", "no such image", "such as --scene "});
    }
}

/// A detector's box of each object of BopFolder in image 0 of scene 1, and of one in image 3.
std::string some_boxes(double left) {
    std::string text;
    for (auto const& [image, object] : {std::pair(0, 1), std::pair(0, 5), std::pair(3, 5)})
        text += fmt::format(R"({}{{"scene_id": 1, "image_id": {}, "category_id": {}, "bbox": [{}, 10.5, 20, 20.25], )"
                            R"("score": 0.5, "time": 0.1}})",
                            text.empty() ? "[" : ", ", image, object, left);
    return text + "]";
}

TEST_CASE("Every target with a box is looked for, and an interrupted estimate of all goes on", "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    dataset.write("boxes.json", some_boxes(20));
    auto const all = [&](Words more) {
        more.insert(more.begin(), {"--all", "--bop", dataset.path().string()});
        return workspace.estimate(more);
    };
    Words const words{"--detections", (dataset / "boxes.json").string(), "--out", "all",
                      "--set",        "estimator.iterations=2"};
    CommandResult const first = all(words);
    require_done(first);
    CHECK_THAT(first.out, Contains("8 targets, 5 without a box; 3 estimates, 0 of them done already") &&
                              Contains("written: all/results.csv"));
    std::string const results = workspace.text("all/results.csv");
    std::vector<std::string> const lines = lines_of(results);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "scene_id,im_id,obj_id,score,R,t,time");
    CHECK(lines[1].rfind("1,0,1,", 0) == 0);
    CHECK(lines[3].rfind("1,3,5,", 0) == 0);
    for (std::size_t i = 1; i < 4; ++i)
        CHECK(lines[i].substr(lines[i].size() - 3) == ",-1");

    CommandResult const again = all(words);
    require_done(again);
    CHECK_THAT(again.out, Contains("3 of them done already"));
    CHECK(workspace.text("all/results.csv") == results);
    dataset.replace("boxes.json", "[20,", "[21,");  // one box is another
    CHECK_THAT(all(words).out, Contains("2 of them done already"));
    CHECK(workspace.text("all/results.csv") != results);
    require_done(workspace.run({"evaluate", "all/results.csv", dataset.path().string()}));
}

TEST_CASE("What is wrong with a target ends an estimate of all with the reason, and what was done is kept",
          "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    std::string const mesh = content_of(dataset / "models/obj_000005.ply");
    auto const all = [&] {
        return workspace.estimate({"--all", "--bop", dataset.path().string(), "--detections",
                                   (dataset / "boxes.json").string(), "--out", "all", "-j", "1", "--set",
                                   "estimator.iterations=1", "--set", "workload.samples.count=4"});
    };
    dataset.write("boxes.json", some_boxes(20));
    dataset.write("models/obj_000005.ply", "");
    CommandResult const broken = all();
    CHECK(broken.exit_code == 2);
    CHECK_THAT(broken.err, Contains("object 5 in image 0 of scene 1: ") &&
                               Contains("obj_000005.ply: cannot be read as a mesh (it ends early)"));
    CHECK(lines_of(broken.err).size() == 1);
    std::filesystem::remove(dataset / "models/obj_000005.ply");
    std::filesystem::create_directory(dataset / "models/obj_000005.ply");
    CHECK_THAT(all().err, Contains("obj_000005.ply: is a folder, expected a file"));
    std::filesystem::remove(dataset / "models/obj_000005.ply");
    dataset.write("models/obj_000005.ply", mesh);
    dataset.write("boxes.json", some_boxes(-1e10));
    dataset.replace("boxes.json", "20, 20.25", "3e10, 20.25");  // of the first
    CHECK_THAT(all().err,
               Contains("boxes.json: [0].bbox = an array of 4") && Contains("no more than a million pixels"));
    CHECK_FALSE(workspace.has("all/results.csv"));
    dataset.write("boxes.json", some_boxes(20));
    CommandResult const mended = all();
    require_done(mended);
    CHECK_THAT(mended.out, Contains("3 estimates, 1 of them done already"));
}

TEST_CASE("Instances of an object are looked for in the best boxes one by one", "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    dataset.write("test_targets_bop19.json", R"([{"scene_id": 1, "im_id": 0, "obj_id": 5, "inst_count": 2}])");
    std::string text;
    for (char const* const score : {"0.2", "0.9", "0.5"})
        text += fmt::format(
            R"({}{{"scene_id": 1, "image_id": 0, "category_id": 5, "bbox": [20, 10, 20, 20], "score": {}}})",
            text.empty() ? "[" : ", ", score);
    dataset.write("boxes.json", text + "]");
    CommandResult const result =
        workspace.estimate({"--all", "--bop", dataset.path().string(), "--detections",
                            (dataset / "boxes.json").string(), "--out", "all", "--set", "estimator.iterations=1"});
    require_done(result);
    CHECK_THAT(result.out, Contains("1 targets, 0 without a box; 2 estimates"));
    CHECK(lines_of(workspace.text("all/results.csv")).size() == 3);
}

TEST_CASE("Without a detector the most visible instances are looked for", "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    dataset.add_cylinder(0.1);
    dataset.replace("test/000001/scene_gt_info.json", "[11, 13, 9, 8]", "[90, 90, 1, 1]");
    dataset.write("test_targets_bop19.json", R"([{"scene_id": 1, "im_id": 0, "obj_id": 5}])");  // of both
    auto const estimates_of = [&](char const* name) {
        require_done(workspace.estimate({"--all", "--bop", dataset.path().string(), "--out", name, "--set",
                                         "estimator.iterations=1", "--set", "workload.samples.count=4"}));
        return lines_of(workspace.text(name + std::string("/results.csv"))).size() - 1;
    };
    CHECK(estimates_of("both") == 2);
    dataset.replace("test_targets_bop19.json", "5}", "5, \"inst_count\": 1}");
    CHECK(estimates_of("one") == 1);
}

TEST_CASE("Boxes outside of their images are left out, and that is said", "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    dataset.write("boxes.json", some_boxes(20));
    dataset.replace("boxes.json", "[20,", "[70,");
    CommandResult const result = workspace.estimate({"--all", "--bop", dataset.path().string(), "--out", "all",
                                                     "--detections", (dataset / "boxes.json").string(), "--set",
                                                     "estimator.iterations=1", "--set", "workload.samples.count=4"});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("boxes outside of their images are left out: 1, such as [70, 10.5, 20, 20.25] in "
                                    "image 0 of scene 1"));
    CHECK_THAT(result.out, Contains("8 targets, 6 without a box; 2 estimates"));
}

TEST_CASE("An estimate of all needs a dataset, a folder and boxes, and is of no single object", "[estimate][bop]") {
    Workspace const workspace;
    BopFolder const dataset;
    std::string const folder = dataset.path().string();
    check_bad_input(workspace.estimate({"--all", "--out", "all"}), {"--all", "--bop DIR and --out DIR"});
    check_bad_input(workspace.estimate({"--all", "--bop", folder}), {"--all", "--bop DIR and --out DIR"});
    check_bad_input(workspace.estimate({"--all", "--bop", folder, "--out", "all", "--object", "1"}),
                    {"--all: expected none of --scene"});
    check_bad_input(workspace.estimate({"--all", "--bop", folder, "--out", "all", "--scene", "0"}),
                    {"--all: expected none of --scene"});
    dataset.write("boxes.json", "[]");
    check_bad_input(workspace.estimate(
                        {"--all", "--bop", folder, "--out", "all", "--detections", (dataset / "boxes.json").string()}),
                    {"boxes.json: has a box for none of the 8 targets"});
    dataset.write("test_targets_bop19.json", "[]");
    check_bad_input(workspace.estimate({"--all", "--bop", folder, "--out", "all"}), {"has no targets, expected some"});
    CHECK_FALSE(workspace.has("all"));
}

TEST_CASE("A run does not know the keys of estimate", "[estimate]") {
    Workspace const workspace;
    require_done(workspace.run({"run", "config.yaml", "--out", "run"}));
    CHECK_THAT(workspace.text("run/summary.json"), !Contains("estimator") && !Contains("host.start"));
}

TEST_CASE("Restarts and the refinement cost their time, and the files say which run was kept", "[estimate]") {
    Workspace const workspace;
    Words const words{"--set", "estimator.restarts=3", "--set", "estimator.iterations=2",
                      "--set", "host.refine_us=250000"};
    Words plain = words, refined = words, alone = words;
    plain.insert(plain.end(), {"--out", "plain", "-j", "2"});
    alone.insert(alone.end(), {"--out", "alone", "-j", "1"});
    refined.insert(refined.end(), {"--out", "refined", "-j", "2", "--set", "estimator.refine=icp"});
    CommandResult const result = workspace.estimate(plain);
    require_done(result);
    require_done(workspace.estimate(alone));
    require_done(workspace.estimate(refined));
    CHECK_THAT(result.out, Contains("6 iterations of 60 samples") && Contains("of 3, the heaviest"));
    CHECK(workspace.text("plain/estimate.json") == workspace.text("alone/estimate.json"));
    Json const found = workspace.json("plain/estimate.json"), moved = workspace.json("refined/estimate.json");
    CHECK(found["runs"] == 3);
    REQUIRE(found["iterations"].size() == 6);
    double ms = 0, heaviest = 0;
    for (std::size_t k = 0; k < 6; ++k) {
        Json const& row = found["iterations"][k];
        CHECK(row["iteration"] == k);
        CHECK(row["run"] == k / 2);
        CHECK(row["cycles"].get<std::uint64_t>() > 0);
        ms += row["iteration_ms"].get<double>();
        heaviest = std::max(heaviest, row["best_weight"].get<double>());
    }
    CHECK(found["weight"] == heaviest);
    CHECK(found["iterations"][2 * found["run"].get<std::size_t>() + 1]["best_weight"] == heaviest);
    CHECK(found["total_ms"].get<double>() == Approx(ms));
    CHECK(found["refine_ms"] == 0);
    CHECK(moved["refine_ms"] == 250);
    CHECK(moved["total_ms"].get<double>() == Approx(ms + 250));
    CHECK(moved["total_mj"]["typical"].get<double>() > found["total_mj"]["typical"].get<double>());
    CHECK(moved["weight"] == heaviest);
    CHECK(cells_of(lines_of(workspace.text("plain/iterations.csv")).front()).back() == "run");
    CHECK(cells_of(lines_of(workspace.text("plain/iterations.csv")).back()).back() == "2");
}

TEST_CASE("What cannot be found is said clearly", "[estimate]") {
    Workspace const workspace;
    SECTION("an empty table in the place of the object") {
        // The box is where the can would be; it stands outside the image.
        Words const words{"--untimed",
                          "--out",
                          "out",
                          "--set",
                          "workload.pose.translation_m=[3,0,0.65]",
                          "--set",
                          "estimator.box.left=60",
                          "--set",
                          "estimator.box.top=40",
                          "--set",
                          "estimator.box.width=30",
                          "--set",
                          "estimator.least_weight=0.99"};
        CommandResult const result = workspace.estimate(words);
        require_done(result);
        CHECK_THAT(result.out, Contains("Weak: the best weight is"));
        CHECK(workspace.json("out/estimate.json")["verdict"] == "weak");
    }
    SECTION("an object outside the image, for which there is no box") {
        require_done(
            workspace.estimate({"--untimed", "--out", "out", "--set", "workload.pose.translation_m=[3,0,0.65]"}));
        CHECK(workspace.json("out/estimate.json")["boxes"].empty());
    }
    SECTION("a scene without readings") {
        CommandResult const result =
            workspace.estimate({"--untimed", "--out", "out", "--set", "workload.scene.noise.random_dropout=1"});
        require_done(result);
        CHECK_THAT(result.out, Contains("no readings in the box"));
        CHECK(workspace.json("out/estimate.json")["verdict"] == "no_readings");
    }
    SECTION("half of the object is outside the image") {
        require_done(workspace.estimate({"--out", "out", "--set", "workload.pose.translation_m=[0.37,0,0.65]"}));
        Json const found = workspace.json("out/estimate.json");
        CHECK(found["boxes"].size() == 1);
        CHECK(found["boxes"][0]["left"].get<double>() + found["boxes"][0]["width"].get<double>() <= 159);
        CHECK(found["iterations"].size() == 6);
    }
}

TEST_CASE("estimate refuses what it cannot use in one line, and writes nothing", "[estimate]") {
    Workspace const workspace;
    auto const refuses = [&](Words words, Words const& expected) {
        words.insert(words.end(), {"--out", "out"});
        check_bad_input(workspace.estimate(words), expected);
    };
    refuses({"--set", "estimator.box.left=160", "--set", "estimator.box.width=20"},
            {"estimator.box.left", "a box that overlaps the image of 160 x 120 pixels"});
    refuses({"--set", "estimator.box.top=-30", "--set", "estimator.box.width=20"}, {"estimator.box.top"});
    refuses({"--set", "estimator.weights.accelerator.raw=0.5"}, {"estimator.weights.accelerator", "add up to 1"});
    refuses({"--set", "estimator.weights.in_box=none", "--set", "estimator.weights.grip.in_box=1"},
            {"estimator.weights.grip.in_box", "less than 1"});
    refuses({"--set", "estimator.weights.in_box=points"}, {"estimator.weights.in_box", "all_points"});
    refuses({"--set", "workload.samples.count=0"}, {"workload.samples.count", "at least 1"});
    refuses({"--set", "workload.trace=" + std::string(FASTER_SOURCE_DIR) + "/traces/one_triangle"},
            {"workload.trace", "moves a mesh"});
    refuses({"--set", "workload.samples.poses=p.csv"}, {"workload.samples.poses", "draws its samples itself"});
    refuses({"--set", "estimator.weights.accelerator.edge=0.1000001"},
            {"estimator.weights.accelerator.edge", "box, in_box, raw, edge", "add up to 1, not to 1.0000001"});
    refuses({"--set", "estimator.weights.grip.planar=0.5"}, {"estimator.weights.grip.planar", "edge, planar"});
    refuses({"--backend", "gripp"}, {"--backend: expected one of accelerator, grip, found gripp, did you mean grip?"});
    refuses({"--bop", "nowhere", "--object", "can"}, {"--object: expected an integer, found can"});
    refuses({"--set", "estimator.iterations=0"}, {"estimator.iterations"});
    refuses({"--set", "estimator.iteration=5"}, {"estimator.iterations"});
    refuses({"-j", "0"}, {"--jobs"});
    refuses({"--bop", "nowhere", "--object", "1"}, {"nowhere"});
    for (char const* const option : {"--split", "--scene", "--image", "--object", "--detections"})
        refuses({option, "7"}, {option, "--bop"});
    refuses({"--models-in", "m"}, {"--models-in", "--bop"});
    refuses({"--iteration", "0"}, {"--iteration", "--events"});
    refuses({"--vcd-cores", "0"}, {"--vcd-cores", "--vcd"});
    refuses({"--set", "estimator.iterations=2", "--traces", "1,2"}, {"--traces 2", "from 0 to 1"});
    refuses({"--set", "estimator.iterations=2", "--pictures", "9"}, {"--pictures 9", "from 0 to 1"});
    check_bad_input(workspace.estimate({"--pictures", "0"}), {"--pictures", "--out"});
    check_bad_input(workspace.estimate({"--traces", "0"}), {"--traces", "--out"});
    check_bad_input(workspace.estimate({"--out", "config.yaml"}), {"config.yaml"});
    CHECK_FALSE(workspace.has("out"));
}

TEST_CASE("A deadlock of the accelerator ends an estimate with its report", "[estimate]") {
    Workspace const workspace;
    for (char const* const jobs : {"1", "2"}) {
        CommandResult const result =
            workspace.estimate({"--out", "out", "-j", jobs, "--set", "accelerator.fifos.fragment_depth.depth=1"});
        CHECK(result.exit_code == 3);
        CHECK_THAT(result.err, Contains("fragment_depth"));
        CHECK_FALSE(workspace.has("out"));
    }
}

}  // namespace estimate_test
