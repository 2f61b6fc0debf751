#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <iostream>
#include <random>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/sweep_workspace.hpp"

namespace sweep_resume_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Seconds = std::chrono::duration<double>;

/// Starts a sweep in the background, with what it prints thrown away. `prepare` is called in the new process.
template <class Prepare> pid_t start_sweep(SweepWorkspace const& workspace, char const* out, Prepare prepare) {
    std::string const folder = workspace.folder().path().string();
    pid_t const child = fork();
    REQUIRE(child >= 0);
    if (child != 0)
        return child;
    prepare();
    bool const is_there = chdir(folder.c_str()) == 0 && std::freopen("/dev/null", "w", stdout) != nullptr &&
                          std::freopen("sweep.err", "w", stderr) != nullptr;
    if (is_there)
        execl(FASTER_SIM_BINARY, FASTER_SIM_BINARY, "sweep", "sweep.yaml", "--out", out, "-j", "2", nullptr);
    _exit(127);
}

int wait_for(pid_t process) {
    int status = 0;
    REQUIRE(waitpid(process, &status, 0) == process);
    return status;
}

/// True if the sweep was killed before it was done.
bool kill_after(SweepWorkspace const& workspace, char const* out, Seconds delay) {
    pid_t const process = start_sweep(workspace, out, [] {});
    std::this_thread::sleep_for(delay);
    kill(process, SIGKILL);
    return WIFSIGNALED(wait_for(process));
}

void check_same(SweepWorkspace const& workspace, std::string const& out, std::string const& undisturbed) {
    for (std::string const file : {"/results.csv", "/index.html", "/sweep.json"})
        CHECK(workspace.text(out + file) == workspace.text(undisturbed + file));
    std::vector<std::string> rows = lines_of(workspace.text(out + "/journal"));
    std::vector<std::string> expected = lines_of(workspace.text(undisturbed + "/journal"));
    std::sort(rows.begin(), rows.end());
    std::sort(expected.begin(), expected.end());
    CHECK(rows == expected);  // no row twice, none lost
    CHECK_FALSE(workspace.has(out + "/events"));
}

TEST_CASE("A sweep that is killed at 10 random moments ends like one that is not", "[sweeps]") {
    SweepWorkspace const workspace;
    auto const start = std::chrono::steady_clock::now();
    require_done(workspace.sweep("undisturbed", {"-j", "2"}));
    // A sweep goes on where it was, so that short times reach its end as well, also where the host is busy.
    Seconds const longest = std::min<Seconds>(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
    unsigned const seed = std::random_device()();
    std::cout << "seed " << seed << std::endl;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    std::size_t kills = 0, rounds = 0;
    while (kills < 10) {
        REQUIRE(++rounds < 200);
        if (kill_after(workspace, "out", longest * share(random))) {
            ++kills;
            continue;
        }
        check_same(workspace, "out", "undisturbed");
        std::filesystem::remove_all(workspace.folder() / "out");
    }
    require_done(workspace.sweep("out"));
    check_same(workspace, "out", "undisturbed");
}

TEST_CASE("A sweep on a full disk says so, and goes on when there is room", "[sweeps]") {
    SweepWorkspace const workspace;
    workspace.folder().write("sweep.yaml", workspace.text("sweep.yaml") +
                                               "  - {key: accelerator.clock_mhz, range: [100, 400], step: 100}\n");
    require_done(workspace.sweep("undisturbed"));
    // A file that may not grow takes what fits and then fails, as on a full disk.
    auto const run_with_room = [&](rlim_t bytes) {
        int const status = wait_for(start_sweep(workspace, "out", [bytes] {
            std::signal(SIGXFSZ, SIG_IGN);
            rlimit const limit{bytes, bytes};
            setrlimit(RLIMIT_FSIZE, &limit);
        }));
        REQUIRE(WIFEXITED(status));
        return WEXITSTATUS(status);
    };
    std::set<std::size_t> rows;
    for (rlim_t const bytes : std::vector<rlim_t>{100, 12000, 15000, 18000, 21000}) {
        CHECK(run_with_room(bytes) == 2);
        CHECK_THAT(workspace.text("sweep.err"), Contains("cannot be written") || Contains("cannot write it"));
        CHECK(lines_of(workspace.text("sweep.err")).size() == 1);
        rows.insert(lines_of(workspace.text("out/journal")).size());
        CHECK_FALSE(workspace.has("out/results.csv"));
    }
    CHECK(rows.size() > 2);  // it got further each time
    require_done(workspace.sweep("out"));
    check_same(workspace, "out", "undisturbed");
}

TEST_CASE("Two sweeps in one folder are refused", "[sweeps]") {
    SweepWorkspace const workspace;
    pid_t const process = start_sweep(workspace, "out", [] {});
    for (int i = 0; i < 20'000 && !workspace.has("out/journal"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(process, SIGSTOP);
    CommandResult const second = workspace.sweep("out");
    kill(process, SIGCONT);
    CHECK(wait_for(process) == 0);
    check_bad_input(second, {"out: another faster-sim is at work in it"});
    require_done(workspace.sweep("undisturbed"));
    check_same(workspace, "out", "undisturbed");
}

TEST_CASE("Event files that were exchanged between two runs of a sweep are made anew", "[sweeps]") {
    SweepWorkspace const workspace;
    auto const write_sweep = [&](std::string const& cores) {
        workspace.folder().write("sweep.yaml", SweepWorkspace::head() +
                                                   "  - {key: workload.samples.count, values: [1, 3]}\n"
                                                   "  - {key: accelerator.raster_cores, values: " +
                                                   cores + "}\n");
    };
    write_sweep("[1, 2]");
    require_done(workspace.sweep("out", {"--keep-events"}));
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::directory_iterator(workspace.folder() / "out/events"))
        files.push_back(entry.path());
    REQUIRE(files.size() == 2);
    std::filesystem::path const aside = workspace.folder() / "aside";
    std::filesystem::rename(files[0], aside);
    std::filesystem::rename(files[1], files[0]);
    std::filesystem::rename(aside, files[1]);
    write_sweep("[1, 2, 3]");
    require_done(workspace.sweep("out"));
    require_done(workspace.sweep("undisturbed"));
    check_same(workspace, "out", "undisturbed");
}

/// Half of a sweep, then the rest: refused while the file is another, done when it is what it was.
void check_change(SweepWorkspace const& workspace, std::string const& sweep, std::string const& file,
                  std::string const& newer) {
    CAPTURE(sweep, file);
    auto const go = [&](std::vector<std::string> const& more) {
        std::vector<std::string> words{"sweep", sweep, "--out", "out"};
        words.insert(words.end(), more.begin(), more.end());
        return workspace.tool(words);
    };
    std::filesystem::remove_all(workspace.folder() / "out");
    require_done(go({"--shard", "1/2"}));
    std::string const older = workspace.text(file), journal = workspace.text("out/journal");
    REQUIRE(newer != older);
    workspace.folder().write(file, newer);
    check_bad_input(go({}), {"out: holds the sweep " + sweep, "points are not in " + sweep});
    CHECK(workspace.text("out/journal") == journal);
    workspace.folder().write(file, older);
    require_done(go({}));
    CHECK(workspace.text("out/journal").rfind(journal, 0) == 0);
}

std::string triangle(std::string const& top) {
    return "v -0.05 -0.05 0\nv 0.05 -0.05 0\nv 0 " + top + " 0\nf 1 3 2\nf 1 2 3\n";
}

std::string replaced(std::string text, std::string const& older, std::string const& newer) {
    return text.replace(text.find(older), older.size(), newer);
}

TEST_CASE("A sweep does not go on with another configuration, overlay, mesh, image or trace", "[sweeps]") {
    SweepWorkspace const workspace;
    std::string const config =
        replaced(replaced(workspace.text("config.yaml"), "tomato_soup_can", "./mesh.obj"), "scene: {downscale: 4}",
                 "camera: {width: 80, height: 60, fx: 70, fy: 70, cx: 39.5, cy: 29.5}");
    workspace.folder().write("config.yaml", config);
    workspace.folder().write("mesh.obj", triangle("0.05"));
    for (std::string const seed : {"1", "2"})
        require_done(
            workspace.tool({"record", "config.yaml", "--out", "trace" + seed, "--set", "workload.scene.seed=" + seed,
                            "--set", "workload.samples.seed=" + seed, "--set", "workload.samples.count=2"}));
    workspace.folder().write("depth.png", workspace.text("trace1/depth.png"));
    std::string const cores = "  - {key: accelerator.raster_cores, values: [1, 2]}\n";
    workspace.folder().write("image.yaml",
                             "format: faster-sweep\nversion: 1\nbase: config.yaml\n"
                             "set: {workload.samples.count: 1, workload.scene.depth_image: ./depth.png}\ndimensions:\n"
                             "  - {overlay: design, files: [plain.yaml, quick.yaml]}\n" +
                                 cores);
    workspace.folder().write(
        "traced.yaml", "format: faster-sweep\nversion: 1\nset: {workload.trace: ./trace1}\ndimensions:\n" + cores);
    check_change(workspace, "image.yaml", "config.yaml", replaced(config, "120", "100"));
    check_change(workspace, "image.yaml", "plain.yaml", "accelerator: {clock_mhz: 100}\n");
    check_change(workspace, "image.yaml", "mesh.obj", triangle("0.06"));
    check_change(workspace, "image.yaml", "depth.png", workspace.text("trace2/depth.png"));
    check_change(workspace, "traced.yaml", "trace1/samples.csv", workspace.text("trace2/samples.csv"));
}

TEST_CASE("A file that changes under a sweep at work ends it before any result is wrong", "[sweeps]") {
    SweepWorkspace const workspace;
    std::string const config = workspace.text("config.yaml");
    pid_t const process = start_sweep(workspace, "out", [] {});
    for (int i = 0; i < 20'000 && !workspace.has("out/journal"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(process, SIGSTOP);
    workspace.folder().write("config.yaml", replaced(config, "120", "100"));
    kill(process, SIGCONT);
    int const status = wait_for(process);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 2);
    CHECK_THAT(workspace.text("sweep.err"),
               Contains("its configuration, or a file that it names, changed while the sweep was at work"));
    CHECK(lines_of(workspace.text("sweep.err")).size() == 1);
    workspace.folder().write("config.yaml", config);
    require_done(workspace.sweep("out"));
    require_done(workspace.sweep("undisturbed"));
    check_same(workspace, "out", "undisturbed");
}

}  // namespace sweep_resume_test
