#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/is_instrumented.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace resources_test {

using namespace faster::test;

TEST_CASE("The tool starts in less than 0.2 seconds", "[resources]") {
    TempFolder const folder;
    double fastest = 10;
    for (int i = 0; i < 5; ++i) {  // the machine may be busy with something else
        CommandResult const help = run_command(FASTER_SIM_BINARY, {"--help"}, folder.path());
        require_done(help);
        fastest = std::min(fastest, help.seconds);
    }
    CHECK((is_instrumented || fastest < 0.2));
}

TEST_CASE("The main job needs less than 60 MB", "[resources]") {
    TempFolder const folder;
    CommandResult const run =
        run_command(FASTER_SIM_BINARY,
                    {"run", FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml", "--out", folder / "out"}, folder.path());
    require_done(run);
    CAPTURE(run.peak_megabytes);
    CHECK((is_instrumented || run.peak_megabytes < 60));
}

TEST_CASE("To record a run that hardly repeats itself takes little more memory, and changes nothing", "[resources]") {
    TempFolder const folder;  // few large triangles, turned at random: no line is like another
    std::vector<std::string> const run{"run",   folder.write("empty.yaml", ""),
                                       "--set", "workload.max_triangles=12",
                                       "--set", "workload.samples.rotation_sigma_deg=180",
                                       "--set", "workload.samples.count=400",
                                       "--set", "workload.scene.table=false",
                                       "--set", "accelerator.fraction_bits.vertex_xy=4",
                                       "--set", "workload.pose.translation_m=[0,0,0.4]"};
    auto const with = [&run](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), run.begin(), run.end());
        return arguments;
    };
    CommandResult const plain = run_command(FASTER_SIM_BINARY, with({"--out", folder / "a"}), folder.path());
    CommandResult const recorded =
        run_command(FASTER_SIM_BINARY, with({"--out", folder / "b", "--events", folder / "b.events"}), folder.path());
    require_done_with_warnings(plain);  // a sample is turned out of sight
    require_done_with_warnings(recorded);
    CAPTURE(plain.peak_megabytes, recorded.peak_megabytes);
    CHECK((is_instrumented || recorded.peak_megabytes < plain.peak_megabytes + 70));
    for (char const* const table : {"samples.csv", "fifos.csv", "loops.csv"})
        CHECK(content_of(folder / "a" / table) == content_of(folder / "b" / table));
}

TEST_CASE("A run that is interrupted leaves nothing", "[resources]") {
    for (char const* const signal : {"INT", "TERM", "KILL"}) {
        CAPTURE(signal);
        TempFolder const folder;
        CommandResult const run =
            run_command("/usr/bin/timeout",
                        {"--foreground", "-s", signal, "0.3", FASTER_SIM_BINARY, "run",
                         FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml", "--set", "simulation.engine=lockstep",
                         "--out", "new/out", "--report", "report.html", "--events", "run.events"},
                        folder.path());
        CHECK(run.exit_code != 0);
        CHECK(entries_in(folder.path()) == 0);
    }
}

}  // namespace resources_test
