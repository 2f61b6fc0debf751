#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/is_instrumented.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace work_size_test {

using namespace faster::test;
using Words = std::vector<std::string>;

CommandResult tool(SmallWorkspace const& workspace, Words const& words) {
    return run_command(FASTER_SIM_BINARY, words, workspace.folder().path());
}

TEST_CASE("A run of days asks whether it is meant") {
    SmallWorkspace const workspace;
    check_bad_input(workspace.run({"--set", "workload.samples.count=1000000", "--set", "accelerator.window=4096",
                                   "--set", "simulation.engine=lockstep", "--out", "out"}),
                    {"run: would take long (1000000 samples, about ", " days",
                     "expected less than an hour of work, or run --force"});
    CHECK(workspace.files_in("") == 1);
}

TEST_CASE("A run for which there is too little memory is refused before it starts") {
    SmallWorkspace const workspace;
    Words words{"--set", "accelerator.raster_cores=1024", "--set", "accelerator.window=4096"};
    for (std::string const fifo : {"edge_token", "command", "fragment_depth", "fragment_index", "observed_depth",
                                   "observed_edge", "edge_map", "area", "area_reciprocal", "vertex"})
        words.insert(words.end(), {"--set", "accelerator.fifos." + fifo + ".depth=1048576"});
    auto const result = workspace.run(words);
    check_bad_input(result, {"run: would take about ", "GiB of memory, of which ", "expected less, or run --force"});
    CHECK(result.seconds < 10);
}

TEST_CASE("Whatever computes for hours asks whether that is meant, before it computes") {
    SmallWorkspace const workspace;
    workspace.folder().write("experiment.yaml",
                             "format: faster-experiment\nversion: 1\n"
                             "set: {workload.samples.count: 100000, estimator.iterations: 100000}\n"
                             "scenes: {dark: {objects: [banana], images: 1, visible: [0.8, 1]}}\n"
                             "methods: {faster: {}, grip: {estimator.backend: grip}}\n");
    std::string const samples = "workload.samples.count=1000000", window = "accelerator.window=2000";
    std::string const lockstep = "simulation.engine=lockstep";
    auto const [words, amount] = GENERATE_COPY(table<Words, std::string>(
        {{{"grip", "config.yaml", "-j", "1", "--set", samples, "--set", window}, "1000000 samples, about "},
         {{"estimate", "config.yaml", "--set", samples, "--set", "estimator.iterations=100000"},
          "100000 iterations of 1000000 samples: about "},
         {{"estimate", "config.yaml", "--backend", "grip", "--set", samples, "--set", "estimator.iterations=100000"},
          "100000 iterations of 1000000 samples: about "},
         {{"record", "config.yaml", "--out", "t", "--set", "workload.samples.count=1000000"}, " of memory, of which "},
         {{"edge-quality", "--poses", "100000"}, " edge maps: about "},
         {{"experiment", "experiment.yaml", "--out", "out", "-j", "1"}, "2 estimates: about "},
         {{"explore", "config.yaml", "--set", samples, "--set", lockstep, "--set", window},
          "1000000 samples, about "}}));
    CAPTURE(words);
    auto const result = tool(workspace, words);
    check_bad_input(
        result, {words.front() == "explore" ? "run: would take" : words.front() + ": would take", amount, "--force"});
    CHECK(result.seconds < 30);
}

TEST_CASE("A comparison with the twin whose maps do not fit into memory is refused") {
    if (is_instrumented)  // whose memory no limit allows
        return;
    SmallWorkspace const workspace;
    require_done(tool(workspace, {"record", "config.yaml", "--out", "trace", "--set", "accelerator.window=255", "--set",
                                  "workload.samples.count=3000"}));
    check_bad_input(run_command("/bin/sh",
                                {"-c", "ulimit -v 700000; exec \"$@\"", "sh", FASTER_SIM_BINARY, "cosim", "trace",
                                 "--set", "accelerator.raster_cores=1"},
                                workspace.folder().path()),
                    {"cosim: would take about 0.7 GiB of memory, of which "});
}

TEST_CASE("What is retimed is refused where the machine does not fit into memory") {
    if (is_instrumented)  // whose memory no limit allows
        return;
    SmallWorkspace const workspace;
    Words const large{"--set", "accelerator.raster_cores=24", "--set", "accelerator.fifos.edge_token.depth=1048576"};
    auto const run_with = [&](Words words) {
        words.insert(words.end(), large.begin(), large.end());
        return workspace.run(words);
    };
    require_done(workspace.run({"--events", "small.events"}));
    require_done(run_with({"--events", "large.events"}));
    workspace.folder().write("matrix.yaml",
                             "- {}\n- {accelerator.raster_cores: 24, accelerator.fifos.edge_token.depth: 1048576}\n");
    for (Words words : {Words{"whatif", "small.events", large[0], large[1], large[2], large[3]},
                        Words{"whatif", "small.events", "--matrix", "matrix.yaml"},
                        Words{"size-fifos", "small.events", "--within", "5", large[0], large[1], large[2], large[3]},
                        Words{"sensitivities", "large.events"}}) {
        Words limited{"-c", "ulimit -v 700000; exec \"$@\"", "sh", FASTER_SIM_BINARY};
        limited.insert(limited.end(), words.begin(), words.end());
        CAPTURE(words);
        check_bad_input(run_command("/bin/sh", limited, workspace.folder().path()),
                        {words.front() + ": would take about 0.8 GiB of memory, of which 0.", " GiB are available"});
    }
}

TEST_CASE("A few retimings say nothing of their size, and --force changes nothing of them") {
    SmallWorkspace const workspace;
    require_done(workspace.run({"--events", "in.events"}));
    auto const plain = tool(workspace, {"sensitivities", "in.events"});
    auto const forced = tool(workspace, {"sensitivities", "in.events", "--force"});
    require_done(plain);
    CHECK(plain.out == forced.out);
    CHECK(plain.out.find("retimings") == std::string::npos);
}

TEST_CASE("A short run says nothing of its size, and --force changes nothing of it") {
    SmallWorkspace const workspace;
    auto const plain = workspace.run({"--out", "a"});
    auto const forced = workspace.run({"--out", "b", "--force"});
    require_done(plain);
    require_done(forced);
    CHECK(plain.out.find("about") == std::string::npos);
    CHECK(workspace.text("a/samples.csv") == workspace.text("b/samples.csv"));
}

}  // namespace work_size_test
