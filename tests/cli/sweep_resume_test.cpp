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

TEST_CASE("A sweep that is killed at 20 random moments ends like one that is not", "[sweeps]") {
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
    while (kills < 20) {
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

}  // namespace sweep_resume_test
