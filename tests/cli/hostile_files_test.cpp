// Whatever the files hold: one line, exit code 2, nothing that a terminal would obey.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace hostile_files_test {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using faster::test::check_bad_input;
using faster::test::CommandResult;
using faster::test::run_command;
using faster::test::SmallWorkspace;
using Words = std::vector<std::string>;

CommandResult tool(SmallWorkspace const& workspace, Words const& words) {
    return run_command(FASTER_SIM_BINARY, words, workspace.folder().path());
}

/// Through a shell, for what only a shell can do.
CommandResult shell(SmallWorkspace const& workspace, std::string const& command) {
    return run_command("/bin/sh", {"-c", "exec " FASTER_SIM_BINARY " " + command}, workspace.folder().path());
}

TEST_CASE("Names with control characters and foreign bytes are escaped in messages") {
    SmallWorkspace const workspace;
    check_bad_input(tool(workspace, {"run", "a\x1B[2J\n\xFF.yaml"}), {"a\\x1b[2J\\n\\xff.yaml: no such file"});
    check_bad_input(tool(workspace, {"\xE2\x80\xAErun\x1B"}), {"unknown command \\u202erun\\x1b"});
    check_bad_input(tool(workspace, {"run", "config.yaml", "--\x1B"}), {"\\x1b"});
    check_bad_input(tool(workspace, {"run", "config.yaml", "--set", "a\x1B=1"}), {"--set a\\x1b=1"});
}

TEST_CASE("A megabyte of a name becomes a line") {
    SmallWorkspace const workspace;
    workspace.folder().write("long.yaml", "accelerator:\n  window: " + std::string(1'000'000, 'w') + "\n");
    CommandResult const result = tool(workspace, {"run", "long.yaml"});
    check_bad_input(result, {"long.yaml:2: accelerator.window = www", "..., expected an integer"});
    CHECK(result.err.size() < 200);
    CHECK(result.seconds < 5);
}

TEST_CASE("A configuration in a folder of any name runs, and its outputs are sound") {
    SmallWorkspace const workspace;
    std::string const name = "f\x1B\xFF\"";
    fs::create_directory(workspace.folder() / name);
    fs::copy_file(FASTER_SOURCE_DIR "/traces/full_window/trace.yaml", workspace.folder() / "trace.yaml");
    fs::copy(FASTER_SOURCE_DIR "/traces/full_window", workspace.folder() / name / "trace");
    workspace.folder().write(name + "/c.yaml", "workload: {trace: trace}\n");
    CommandResult const result = tool(
        workspace, {"run", name + "/c.yaml", "--out", name + "/out", "--report", "r.html", "--vcd", name + "/w.vcd"});
    faster::test::require_done(result);
    CHECK_THAT(result.out, Contains("written: f\\x1b\\xff\"/out"));
    CHECK(workspace.summary(name + "/out").contains("total_cycles"));
    CHECK(workspace.text(name + "/w.gtkw").find('\x1B') == std::string::npos);
    CHECK(workspace.text("r.html").find('\x1B') == std::string::npos);
}

TEST_CASE("A loop of links is said to be one, wherever a path may stand") {
    SmallWorkspace const workspace;
    fs::create_symlink("loop", workspace.folder() / "loop");
    std::string const loop = "Too many levels of symbolic links";
    check_bad_input(tool(workspace, {"run", "loop"}), {"loop", loop});
    check_bad_input(tool(workspace, {"run", "config.yaml", "--out", "loop"}), {"loop", loop});
    check_bad_input(tool(workspace, {"check", "loop"}), {"loop", loop});
    check_bad_input(tool(workspace, {"sweep", "loop", "--out", "x"}), {"loop", loop});
    check_bad_input(tool(workspace, {"evaluate", "config.yaml", "loop"}), {"loop", loop});
    check_bad_input(tool(workspace, {"compare", "loop", "loop"}), {"loop"});
}

TEST_CASE("A folder in the place of a file is said to be one") {
    SmallWorkspace const workspace;
    fs::create_directory(workspace.folder() / "d");
    for (Words const& words : std::vector<Words>{{"run", "d"},
                                                 {"check", "d"},
                                                 {"check", "--init", "d"},
                                                 {"sweep", "d", "--out", "x"},
                                                 {"whatif", "d"},
                                                 {"size-fifos", "d", "--within", "5"},
                                                 {"compare-architectures", "faster", "--workloads", "d"},
                                                 {"run", "config.yaml", "--set", "workload.scene.depth_image=./d"},
                                                 {"run", "config.yaml", "--report", "d"}}) {
        CommandResult const result = tool(workspace, words);
        check_bad_input(result, {"d", "is a folder"});
        CHECK(result.err.find("unexpected") == std::string::npos);
    }
    check_bad_input(tool(workspace, {"run", "config.yaml", "--set", "workload.trace=./d"}), {"d/trace.yaml"});
    fs::create_directories(workspace.folder() / "t" / "trace.yaml");
    check_bad_input(tool(workspace, {"run", "config.yaml", "--trace", "t"}), {"t/trace.yaml", "is a folder"});
}

TEST_CASE("A full or closed stdout is bad luck in one line, and the files are there") {
    SmallWorkspace const workspace;
    faster::test::require_done(workspace.run({"--events", "a.events"}));
    for (std::string const command : {"run config.yaml --out out", "whatif a.events --out out"}) {
        for (std::string const redirection : {">/dev/full", ">&-"}) {
            CommandResult const result = shell(workspace, command + " " + redirection);
            check_bad_input(result, {"standard output: cannot be written"});
            CHECK(workspace.summary("out").contains("total_cycles"));
        }
    }
}

TEST_CASE("A mesh on which the library that reads it crashes is bad input like any other") {
    SmallWorkspace const workspace;
    std::string const file = FASTER_SOURCE_DIR "/tests/data/meshes/crash.off";
    check_bad_input(workspace.run({"--set", "workload.object=" + file}),
                    {"crash.off: cannot be read as a mesh (the library that reads it", "expected a valid off file"});
}

TEST_CASE("A limit of file sizes is one line, and nothing half-written is left") {
    SmallWorkspace const workspace;
    faster::test::require_done(workspace.run({"--events", "a.events"}));
    std::size_t const files = workspace.files_in("");
    auto const limited = [&](std::string const& limit, std::string const& command, std::string const& why) {
        std::string const line = "ulimit " + limit + "; exec " FASTER_SIM_BINARY " " + command;
        CommandResult const result = run_command("/bin/sh", {"-c", line}, workspace.folder().path());
        CAPTURE(line, result.err);
        check_bad_input(result, {why, "cannot"});
        CHECK(result.err.find("partial") == std::string::npos);
        CHECK(result.err.find("unexpected") == std::string::npos);
        CHECK(workspace.files_in("") == files);
    };
    limited("-f 1", "run config.yaml --out out", "out/summary.json: cannot be written (File too large)");
    limited("-f 1", "run config.yaml --report r.html", "File too large");
    limited("-f 1", "run config.yaml --events b.events", "File too large");
    limited("-f 1", "run config.yaml --timeline t.json", "File too large");
    limited("-f 1", "whatif a.events --out out", "out/summary.json: cannot be written (File too large)");
    limited("-f 1", "check --init config.yaml --out b.yaml", "b.yaml: cannot be written");
}

}  // namespace hostile_files_test
