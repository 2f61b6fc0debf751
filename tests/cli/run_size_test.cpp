#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace run_size_test {

using faster::test::check_bad_input;
using faster::test::SmallWorkspace;

TEST_CASE("A run of days asks whether it is meant") {
    SmallWorkspace const workspace;
    check_bad_input(workspace.run({"--set", "workload.samples.count=1000000", "--set", "accelerator.window=4096",
                                   "--set", "simulation.engine=lockstep", "--out", "out"}),
                    {"the run is long (1000000 samples, about ", " days", "expected a smaller run, or run --force"});
    CHECK(workspace.files_in("") == 1);
}

TEST_CASE("A run for which there is too little memory is refused before it starts") {
    SmallWorkspace const workspace;
    std::vector<std::string> words{"--set", "accelerator.raster_cores=1024", "--set", "accelerator.window=4096"};
    for (std::string const fifo : {"edge_token", "command", "fragment_depth", "fragment_index", "observed_depth",
                                   "observed_edge", "edge_map", "area", "area_reciprocal", "vertex"})
        words.insert(words.end(), {"--set", "accelerator.fifos." + fifo + ".depth=1048576"});
    auto const result = workspace.run(words);
    check_bad_input(result, {"the run takes about ", "GiB of memory, of which ", "expected a smaller run"});
    CHECK(result.seconds < 10);
}

TEST_CASE("A short run says nothing of its size, and --force changes nothing of it") {
    SmallWorkspace const workspace;
    auto const plain = workspace.run({"--out", "a"});
    auto const forced = workspace.run({"--out", "b", "--force"});
    faster::test::require_done(plain);
    faster::test::require_done(forced);
    CHECK(plain.out.find("about") == std::string::npos);
    CHECK(workspace.text("a/samples.csv") == workspace.text("b/samples.csv"));
}

}  // namespace run_size_test
