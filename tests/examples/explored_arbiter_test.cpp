// explore of a design whose accesses do not wait: where they would find something else, it runs the design again.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

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

TEST_CASE("explore takes a run with it that it is waiting for", "[examples]") {
    TempFolder const folder;
    ExploreProcess process(ARBITER_BINARY,
                           {std::filesystem::path(FASTER_SOURCE_DIR) / "examples/arbiter/arbiter.yaml", "--set",
                            "workload.messages=1000000"},
                           folder.path());
    std::string const run = ".explore-" + std::to_string(process.number());
    auto const is_running = [&run] {
        std::filesystem::directory_iterator const files(std::filesystem::temp_directory_path());
        return std::any_of(begin(files), end(files), [&run](std::filesystem::directory_entry const& file) {
            return file.path().filename().string().rfind(run, 0) == 0;
        });
    };
    std::thread asking([&process] {
        post_to(process, process.home() + "retime", R"({"set": ["accelerator.loops.second.produce.ii=3"]})");
    });
    for (int i = 0; i < 2000 && !is_running(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    CHECK(is_running());
    CHECK(process.interrupt() == 0);
    CHECK_FALSE(is_running());
    asking.join();
}

}  // namespace explored_arbiter_test
