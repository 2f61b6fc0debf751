// explore of a design whose accesses do not wait: where they would find something else, it runs the design again.
#include <catch2/catch.hpp>
#include <filesystem>

#include "support/command.hpp"
#include "support/explore_questions.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace explored_arbiter_test {

using namespace faster::test;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

class Explored {
  public:
    Json ask(std::string const& question, Json const& request) {
        return faster::test::ask(process_, question, request);
    }
    /// Of a run with that setting.
    std::uint64_t cycles(std::string const& setting) {
        require_done(
            run_command(ARBITER_BINARY, {"run", configuration_, "--set", setting, "--out", "out"}, folder_.path()));
        return Json::parse(content_of(folder_ / "out/summary.json")).at("total_cycles");
    }

  private:
    TempFolder folder_;
    std::string configuration_ = std::filesystem::path(FASTER_SOURCE_DIR) / "examples/arbiter/arbiter.yaml";
    ExploreProcess process_{ARBITER_BINARY, {configuration_}, folder_.path()};
};

TEST_CASE("explore runs a design again whose accesses would find something else", "[examples]") {
    Explored explored;
    std::string const slower = "accelerator.loops.second.produce.ii=3";
    Words const settings{slower};
    Json const figures = explored.ask("retime", {{"set", settings}});
    CHECK(figures["run_again"] == true);
    CHECK(figures["total_cycles"] == explored.cycles(slower));
    std::uint64_t on_path = 0;
    Json const path = explored.ask("path", {{"set", settings}});
    for (Json const& row : path["rows"])
        on_path += row["cycles"].get<std::uint64_t>();
    CHECK(on_path == figures["total_cycles"]);
    CHECK(explored.ask("timeline", {{"set", settings}, {"sample", 0}})["sample_end"] == figures["total_cycles"]);
    Json const as_recorded = explored.ask("retime", {{"set", Words()}});
    CHECK_FALSE(as_recorded.contains("run_again"));
    CHECK(as_recorded["total_cycles"] == 207);
}

}  // namespace explored_arbiter_test
