#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fmt/format.h>

#include "faster/dataflow_names.hpp"
#include "poses/bop/pose_results.hpp"
#include "support/bop_folder.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace experiment_test {

using namespace faster::test;
using Json = nlohmann::json;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

/// A banana in one image, three methods that hardly look.
class Workspace {
  public:
    Workspace() { write("methods: {faster: {}, grip: {estimator.backend: grip}}\n"); }

    void write(std::string const& methods, std::string const& boxes = "shift: 0.1, wrong: 0.5") const {
        folder_.write("experiment.yaml",
                      "format: faster-experiment\n"
                      "version: 1\n"
                      "set: {workload.samples.count: 12, estimator.iterations: 2, workload.max_triangles: 200}\n"
                      "scenes:\n"
                      "  dark: {objects: [banana], images: 2, visible: [0.8, 1], boxes: {" +
                          boxes + "}}\n" + methods);
    }
    CommandResult experiment(Words words) const {
        words.insert(words.begin(), {"experiment", "experiment.yaml"});
        return run_command(FASTER_SIM_BINARY, words, folder_.path());
    }
    std::string text(std::string const& name) const { return content_of(folder_ / name); }
    TempFolder const& folder() const { return folder_; }

  private:
    TempFolder folder_;
};

TEST_CASE("An experiment makes scenes, looks for objects, judges, and goes on where it was", "[experiment]") {
    Workspace const workspace;
    CommandResult const result = workspace.experiment({"--out", "out", "-j", "2"});
    require_done(result);
    CHECK_THAT(result.out, Contains("4 estimates, 0 of them done already") && Contains("obj_000010"));
    std::string const estimates = workspace.text("out/estimates.csv");
    CHECK(lines_of(estimates).size() == 5);
    CHECK(lines_of(workspace.text("out/results/dark/grip.csv")).size() == 3);
    CHECK(lines_of(workspace.text("out/convergence.csv")).size() == 5);
    CHECK_THAT(workspace.text("out/evaluation/dark/scores.csv"), Contains("faster") && Contains("grip"));
    CHECK_THAT(workspace.text("out/boxes/dark.json"), Contains("bbox"));
    for (std::string const method : {"faster", "grip"}) {
        std::array<int, 4> counts{};  // found, right of them, others, right of them
        for (std::string const& line : lines_of(estimates)) {
            std::vector<std::string> const cells = cells_of(line);
            if (cells[1] != method)
                continue;
            std::size_t const at = cells[8] == "found" ? 0 : 2;
            ++counts[at];
            counts[at + 1] += std::stod(cells[9]) < 20 ? 1 : 0;
        }
        CHECK_THAT(result.out, Contains(fmt::format("| dark | {} | {} |\n", method, fmt::join(counts, " | "))));
    }

    // A journal that lost its last row, and a method more: only these are done.
    std::string const journal = workspace.text("out/journal");
    workspace.folder().write("out/journal", journal.substr(0, journal.rfind('\n', journal.size() - 2) + 1));
    workspace.write(
        "methods: {faster: {}, grip: {estimator.backend: grip}, "
        "inner_border: {accelerator.edge_map.algorithm: inner_border}}\n");
    CommandResult const more = workspace.experiment({"--out", "out", "-j", "1"});
    require_done(more);
    CHECK_THAT(more.out, Contains("6 estimates, 3 of them done already"));
    for (std::string const& line : lines_of(estimates))
        CHECK_THAT(workspace.text("out/estimates.csv"), Contains(line));
}

TEST_CASE("Every estimate that is 2 cm off has a reason that its row of failures.csv bears out", "[experiment]") {
    Workspace const workspace;
    CommandResult const result = workspace.experiment({"--out", "out", "--failures", "3"});
    require_done(result);
    CHECK_THAT(result.out, Contains("failures by reason"));
    std::vector<std::string> const rows = lines_of(workspace.text("out/failures.csv"));
    REQUIRE(rows.size() > 1);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        CAPTURE(rows[i]);
        std::vector<std::string> const cells = cells_of(rows[i]);
        REQUIRE(cells.size() == 12);
        double const weight = std::stod(cells[6]), truth_weight = std::stod(cells[7]);
        double const add_mm = std::stod(cells[8]), adds_mm = std::stod(cells[9]);
        double const mssd_mm = std::stod(cells[10]);
        std::string const& reason = cells[11];
        CHECK(add_mm >= 20);
        CHECK((reason == "symmetry") == (mssd_mm < 20));
        CHECK((reason == "turned") == (adds_mm < 20 && mssd_mm >= 20));
        if (reason == "score" || reason == "search")
            CHECK((reason == "score") == (weight >= truth_weight));
    }
    CHECK(std::filesystem::exists(workspace.folder() / "out/failures/dark.png"));

    workspace.write("methods: {faster: {}}\n", "missing: 1");
    require_done(workspace.experiment({"--out", "out", "--failures", "0"}));
    CHECK_FALSE(std::filesystem::exists(workspace.folder() / "out/failures/dark.png"));
    for (std::string const& row : lines_of(workspace.text("out/failures.csv")))
        if (cells_of(row).front() == "dark" && std::stod(cells_of(row)[9]) >= 20)
            CHECK(cells_of(row).back() == "box");
}

TEST_CASE("Each instance of an object of a dataset is looked for, and judged by the pose nearest to it",
          "[experiment]") {
    Workspace const workspace;
    BopFolder const dataset;
    dataset.add_cylinder(1);
    dataset.write("test_targets_bop19.json", R"([{"scene_id": 1, "im_id": 0, "obj_id": 5}])");
    dataset.replace("test/000001/scene_gt_info.json", "[11, 13, 9, 8]", "[1, 13, 9, 8]");
    workspace.folder().write("experiment.yaml",
                             "format: faster-experiment\nversion: 1\n"
                             "set: {workload.samples.count: 12, estimator.iterations: 2, workload.max_triangles: 200}\n"
                             "scenes: {real: {dataset: " +
                                 dataset.path().string() + "}}\nmethods: {faster: {}}\n");
    require_done(workspace.experiment({"--out", "out"}));
    Json const boxes = Json::parse(workspace.text("out/boxes/real.json"));
    REQUIRE(boxes.size() == 2);
    CHECK(boxes[0]["score"] != boxes[1]["score"]);
    std::vector<std::string> const rows = lines_of(workspace.text("out/estimates.csv"));
    REQUIRE(rows.size() == 3);
    CHECK(cells_of(rows[1]).back() != cells_of(rows[2]).back());
    CHECK(lines_of(workspace.text("out/results/real/faster.csv")).size() == 3);

    // What poses are judged with decides about the result.
    std::filesystem::create_directory(dataset / "models_eval");
    std::filesystem::copy(dataset / "models/obj_000001.ply", dataset / "models_eval/obj_000005.ply");
    std::filesystem::copy(dataset / "models/models_info.json", dataset / "models_eval/models_info.json");
    CHECK_THAT(workspace.experiment({"--out", "out"}).out, Contains("0 of them done already"));
}

TEST_CASE("An estimate that a symmetry maps to the true pose is right but for it, however large its ADD-S",
          "[experiment]") {
    Workspace const workspace;
    BopFolder const dataset;
    dataset.write("test_targets_bop19.json", R"([{"scene_id": 1, "im_id": 0, "obj_id": 1}])");
    workspace.folder().write("experiment.yaml",
                             "format: faster-experiment\nversion: 1\n"
                             "set: {workload.samples.count: 2, estimator.iterations: 1}\n"
                             "scenes: {real: {boxes: {missing: 1}, dataset: " +
                                 dataset.path().string() + "}}\nmethods: {faster: {}}\n");
    auto const failure = [&] {
        require_done(workspace.experiment({"--out", "out", "--failures", "0"}));
        std::vector<std::string> const rows = lines_of(workspace.text("out/failures.csv"));
        REQUIRE(rows.size() == 2);
        return cells_of(rows[1]);
    };
    REQUIRE(std::stod(failure()[9]) > 20);
    CHECK(failure().back() == "box");
    std::vector<std::string> warnings;
    auto const estimates = faster::bop::read_pose_results(workspace.folder() / "out/results/real/faster.csv", warnings);
    faster::Pose const truth = BopFolder::pose_of(1, 0), &found = estimates.at(0).pose;
    Eigen::Matrix3d const r = truth.rotation.transpose() * found.rotation;
    Eigen::Vector3d const t = 1000 * truth.rotation.transpose() * (found.translation - truth.translation);
    dataset.replace("models/models_info.json", "[-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]",
                    fmt::format("[{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0, 0, 0, 1]", r(0, 0), r(0, 1),
                                r(0, 2), t(0), r(1, 0), r(1, 1), r(1, 2), t(1), r(2, 0), r(2, 1), r(2, 2), t(2)));
    CHECK(std::stod(failure()[9]) > 20);
    CHECK(std::stod(failure()[10]) < 1);
    CHECK(failure().back() == "symmetry");
}

TEST_CASE("An experiment refuses in one line what it cannot use", "[experiment]") {
    Workspace const workspace;
    std::filesystem::create_directory(workspace.folder() / "used");
    workspace.folder().write("used/note.txt", "mine");
    check_bad_input(workspace.experiment({"--out", "used"}), {"used", "expected a new or empty folder"});
    check_bad_input(workspace.experiment({"--out", "experiment.yaml"}), {"experiment.yaml", "is a file"});
    workspace.write("methods: {fast: {estimator.iterations: 0}}\n");
    check_bad_input(workspace.experiment({"--out", "new"}), {"experiment.yaml:6", "estimator.iterations"});
    for (std::string const setting : {"workload.samples.count: 0", "workload.samples.poses: poses.csv"}) {
        workspace.write("methods: {fast: {" + setting + "}}\n");
        check_bad_input(workspace.experiment({"--out", "new"}),
                        {"experiment.yaml: methods.fast: ", setting.substr(0, setting.find(':'))});
    }
    CHECK_FALSE(std::filesystem::exists(workspace.folder() / "new"));
}

}  // namespace experiment_test
