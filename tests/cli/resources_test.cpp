#include <algorithm>
#include <catch2/catch.hpp>

#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

using namespace faster::test;

namespace {
#ifdef __SANITIZE_ADDRESS__
constexpr bool is_instrumented = true;  // by a sanitizer, whose memory and time are not ours
#else
constexpr bool is_instrumented = false;
#endif
}  // namespace

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
