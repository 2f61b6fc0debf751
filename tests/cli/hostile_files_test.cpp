// Whatever the files hold: one line, exit code 2, nothing that a terminal would obey.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include "faster/dataflow_names.hpp"
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

TEST_CASE("A table keeps its columns and its lines whatever names are in it") {
    SmallWorkspace const workspace;
    std::string const name = "a,\"b.yaml";
    fs::copy_file(workspace.folder() / "config.yaml", workspace.folder() / name);
    workspace.folder().write("sweep.yaml",
                             "format: faster-sweep\nversion: 1\ndimensions:\n"
                             "  - {overlay: class, files: [\"a,\\\"b.yaml\"]}\n");
    faster::test::require_done(tool(workspace, {"sweep", "sweep.yaml", "--out", "swept"}));
    CHECK_THAT(workspace.text("swept/results.csv"), Contains("\n0,\"a,\"\"b.yaml\",done,"));
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

TEST_CASE("A damaged mesh is bad input like any other") {
    SmallWorkspace const workspace;
    std::string const file = FASTER_SOURCE_DIR "/tests/data/meshes/crash.off";
    check_bad_input(workspace.run({"--set", "workload.object=" + file}),
                    {"crash.off:8: face 1 (counted from 0) has no corners, expected some"});
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

TEST_CASE("Whatever the number of descriptors, a command is done or leaves nothing") {
    SmallWorkspace const workspace;
    std::size_t refused = 0, done = 0;
    for (int most = 3; done < 2 && most < 64; ++most) {  // some may be the caller's
        std::string const limit = "ulimit -n " + std::to_string(most) + "; ";
        std::string const name = "out" + std::to_string(most);
        if (run_command("/bin/sh", {"-c", limit + FASTER_SIM_BINARY " --version || exit 1"}, "/").exit_code != 0)
            continue;  // no room for its libraries
        CommandResult const result = run_command("/bin/sh",
                                                 {"-c", limit + "exec " FASTER_SIM_BINARY " run config.yaml --out " +
                                                            name + " --vcd " + name + "/w.vcd --vcd-to 99"},
                                                 workspace.folder().path());
        CAPTURE(most, result.err);
        bool const is_done = result.exit_code == 0;
        CHECK(is_done == fs::exists(workspace.folder() / name));
        if (!is_done)
            check_bad_input(result, {""});
        CHECK(result.err.find("unexpected") == std::string::npos);
        ++(is_done ? done : refused);
        CHECK(workspace.files_in("") == 1 + done);
    }
    CHECK(refused > 0);
    CHECK(done > 0);
}

TEST_CASE("A folder that may not be written is said to be one, and left alone") {
    SmallWorkspace const workspace;
    faster::test::require_done(workspace.run({"--out", "o", "--events", "a.events"}));
    std::size_t const files = workspace.files_in("");
    // For root, whom permissions do not stop, as somebody else.
    std::string const as_other = geteuid() == 0 ? "setpriv --reuid 65534 --regid 65534 --clear-groups " : "";
    auto const other = [&](std::string const& command) {
        return run_command("/bin/sh", {"-c", "exec " + as_other + FASTER_SIM_BINARY " " + command},
                           workspace.folder().path());
    };
    if (as_other.empty())
        fs::permissions(workspace.folder().path(), fs::perms::owner_write, fs::perm_options::remove);
    if (other("--version").exit_code == 0)  // else the program is where nobody else gets
        for (std::string const command :
             {"run config.yaml --out o", "run config.yaml --out new/o", "run config.yaml --report r.html",
              "run config.yaml --vcd w.vcd", "run config.yaml --timeline t.json", "run config.yaml --events b.events",
              "whatif a.events --out o", "record config.yaml --out t", "compare o o --json c.json",
              "check --init config.yaml --out b.yaml", "grip config.yaml --out g", "estimate config.yaml --out e"}) {
            CAPTURE(command);
            check_bad_input(other(command), {"cannot be written (Permission denied)"});
        }
    fs::permissions(workspace.folder().path(), fs::perms::owner_write, fs::perm_options::add);
    CHECK(workspace.files_in("") == files);
    CHECK(workspace.summary("o").contains("total_cycles"));
}

TEST_CASE("Who reads only the begin of what is printed still gets the files") {
    SmallWorkspace const workspace;
    faster::test::require_done(workspace.run({"--events", "a.events"}));
    std::size_t files = workspace.files_in("");
    for (std::string const command : {"run config.yaml --out o", "whatif a.events --out w", "grip config.yaml --out g",
                                      "record config.yaml --out t", "run config.yaml --report r.html"}) {
        run_command("/bin/sh", {"-c", FASTER_SIM_BINARY " " + command + " | true"}, workspace.folder().path());
        CAPTURE(command);
        CHECK(workspace.files_in("") == ++files);
    }
    CHECK(workspace.summary("o").contains("total_cycles"));
}

TEST_CASE("Several processes at once on one output leave the whole output of one of them") {
    SmallWorkspace const workspace;
    faster::test::require_done(workspace.run({"--out", "one", "--set", "accelerator.raster_cores=1"}));
    workspace.folder().write("one/notes.txt", "mine");
    for (std::string const folder : {"new/o", "one"}) {
        std::string all;
        for (int cores = 1; cores <= 4; ++cores)
            all += FASTER_SIM_BINARY " run config.yaml --set accelerator.raster_cores=" + std::to_string(cores) +
                   " --out " + folder + " --report page.html > /dev/null & ";
        CommandResult const result = run_command("/bin/sh", {"-c", all + "wait"}, workspace.folder().path());
        CHECK(result.err.empty());
        auto const summary = workspace.summary(folder);
        auto const cores = summary.at("configuration").at("accelerator.raster_cores").at("value").get<int>();
        std::string const fifos = workspace.text(folder + "/fifos.csv");
        CHECK(std::count(fifos.begin(), fifos.end(), '\n') == 1 + 14 * cores);
    }
    CHECK(workspace.text("one/notes.txt") == "mine");
    CHECK(workspace.files_in("one") == 7);
    CHECK(workspace.files_in("new") == 1);
    CHECK(workspace.files_in("") == 4);
}

}  // namespace hostile_files_test
