#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace grip_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;
using Json = nlohmann::json;

class Workspace {
  public:
    CommandResult grip(Words words) const {
        words.insert(words.begin(), {"grip", "config.yaml"});
        return run_command(FASTER_SIM_BINARY, words, small_.folder().path());
    }
    std::string text(std::string const& name) const { return small_.text(name); }
    SmallWorkspace const& small() const { return small_; }
    bool has(std::string const& name) const { return std::filesystem::exists(small_.folder() / name); }

  private:
    SmallWorkspace small_;
};

TEST_CASE("grip scores every sample, beside the counters that a run finds", "[grip]") {
    Workspace const workspace;
    CommandResult const result = workspace.grip({"--out", "grip", "-j", "2"});
    require_done(result);
    CHECK_THAT(result.out, Contains("3 samples by GRIP") && Contains("rank correlation of grip and faster"));
    require_done(workspace.small().run({"--out", "run"}));
    Words const scores = lines_of(workspace.text("grip/scores.csv"));
    Words const samples = lines_of(workspace.text("run/samples.csv"));
    REQUIRE(scores.size() == 4);
    double least_rank = 9;
    for (std::size_t i = 1; i < scores.size(); ++i) {
        Words const row = cells_of(scores[i]);
        Words const run = cells_of(samples[i]);
        REQUIRE(row.size() == 16);
        CHECK(Words{row[9], row[10], row[11], row[12]} == Words{run[5], run[7], run[8], run[9]});
        CHECK(std::stoi(row[1]) > 1000);                                    // the can is seen
        CHECK(std::stoi(row[3]) + std::stoi(row[5]) == std::stoi(row[1]));  // edges and planar points
        least_rank = std::min(least_rank, std::stod(row[8]));
    }
    CHECK(least_rank < 2);
    Json const summary = Json::parse(workspace.text("grip/summary.json"));
    CHECK(summary["format"] == "faster-grip");
    CHECK(summary["flow"] == "faster");
    CHECK(summary["samples"] == 3);
    CHECK(summary["host"]["jobs"] == 2);
    CHECK(summary["host"]["grip_seconds"].get<double>() > 0);
    for (char const* const score : {"weight", "raw_ratio", "edge_ratio", "inliers", "edge_inliers"})
        CHECK(summary["rank_correlation"].contains(score));
}

TEST_CASE("grip's scores do not depend on the number of threads, and it compares with any flow", "[grip]") {
    Workspace const workspace;
    require_done(workspace.grip({"--out", "a", "-j", "1"}));
    require_done(workspace.grip({"--out", "b", "-j", "3"}));
    CHECK(workspace.text("a/scores.csv") == workspace.text("b/scores.csv"));
    require_done(workspace.grip({"--out", "c", "--set", "accelerator.flow=fpga_grip"}));
    require_done(workspace.small().run({"--out", "run", "--set", "accelerator.flow=fpga_grip"}));
    Words const score = cells_of(lines_of(workspace.text("c/scores.csv"))[1]);
    Words const run = cells_of(lines_of(workspace.text("run/samples.csv"))[1]);
    CHECK(Words{score[9], score[10], score[11], score[12]} == Words{run[5], run[7], run[8], run[9]});
}

TEST_CASE("grip refuses what it cannot use in one line, and writes nothing", "[grip]") {
    Workspace const workspace;
    std::string const trace = std::string(FASTER_SOURCE_DIR) + "/traces/one_triangle";
    check_bad_input(workspace.grip({"--out", "out", "--set", "workload.trace=" + trace}),
                    {"workload.trace", "expected none", "poses"});
    check_bad_input(workspace.grip({"--out", "out", "--set", "workload.samples.count=0"}),
                    {"workload.samples.count", "at least 1"});
    check_bad_input(workspace.grip({"--out", "out", "-j", "0"}), {"--jobs"});
    check_bad_input(workspace.grip({"--out", "out", "--inlier-distance", "0"}), {"--inlier-distance"});
    check_bad_input(workspace.grip({"--out", "config.yaml"}), {"config.yaml"});
    check_bad_input(workspace.grip({"--out", "out", "--set", "workload.object=mugg"}), {"mug"});
    CHECK_FALSE(workspace.has("out"));
}

}  // namespace grip_test
