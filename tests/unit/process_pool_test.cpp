#include "dataflow/base/process_pool.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace process_pool_test {

using namespace dataflow::processes;
using faster::test::content_of;
using faster::test::TempFolder;
using Kind = Outcome::Kind;

Task quick(std::string const& answer) {
    return {[answer] { return answer; }, 30};
}

std::string hang() {
    for (;;)
        pause();
}

std::string crash() {
    std::signal(SIGSEGV, SIG_DFL);  // not the test framework's report
    raise(SIGSEGV);
    return "";
}

bool is_alive(pid_t process) { return kill(process, 0) == 0; }

/// Waits up to ten seconds.
template <class Condition> bool becomes_true(Condition condition) {
    for (int i = 0; i < 1000 && !condition(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return condition();
}

/// A task that writes its process number to a file and hangs.
Task hanging(std::filesystem::path const& file) {
    return {[file]() -> std::string {
                std::ofstream(file) << getpid() << std::endl;
                return hang();
            },
            60};
}

/// The number, once it is there.
pid_t process_in(std::filesystem::path const& file) {
    REQUIRE(becomes_true([&] { return content_of(file).find('\n') != std::string::npos; }));
    return static_cast<pid_t>(std::stol(content_of(file)));
}

/// Forks a caller of run_all() with one hanging task.
pid_t start_caller(std::filesystem::path const& file) {
    pid_t const caller = fork();
    if (caller == 0) {
        for (int const signal : {SIGINT, SIGTERM})
            std::signal(signal, SIG_DFL);
        {
            SignalWatch const watch;
            try {
                run_all({hanging(file)}, 1, watch);
            } catch (Interrupted const&) {
                std::ofstream(file.string() + ".interrupted") << "yes";
            }
        }
        _exit(0);  // not reached after a signal: the watch lets it through
    }
    return caller;
}

TEST_CASE("Progress counts up to all tasks, whatever becomes of them", "[processes]") {
    SignalWatch const watch;
    std::vector<std::size_t> counts;
    run_all({quick("a"), {crash, 30}, quick("c")}, 2, watch, [&counts](std::size_t done, std::size_t all) {
        CHECK(all == 3);
        counts.push_back(done);
    });
    REQUIRE_FALSE(counts.empty());
    CHECK(counts.back() == 3);
    CHECK(std::is_sorted(counts.begin(), counts.end()));
}

TEST_CASE("Outcomes come in the order of the tasks, whoever is first") {
    SignalWatch const watch;
    auto const slow = [](std::string const& answer) {
        return Task{[answer] {
                        std::this_thread::sleep_for(std::chrono::milliseconds(150));
                        return answer;
                    },
                    30};
    };
    for (std::size_t const jobs : {1U, 2U, 8U}) {
        auto const outcomes = run_all({slow("a"), quick("b"), slow("c"), quick("d")}, jobs, watch);
        REQUIRE(outcomes.size() == 4);
        std::string together;
        for (Outcome const& outcome : outcomes) {
            CHECK(outcome.kind == Kind::done);
            together += outcome.output;
        }
        CHECK(together == "abcd");
    }
    CHECK(run_all({}, 2, watch).empty());
}

TEST_CASE("A task's result may be larger than a pipe holds") {
    SignalWatch const watch;
    std::string const large(3'000'000, 'x');
    CHECK(run_all({quick(large)}, 1, watch).front().output == large);
}

TEST_CASE("A task that sends more than it may is ended, and has failed") {
    SignalWatch const watch;
    Task talkative = quick(std::string(1'000'000, 'x'));
    talkative.most_output_bytes = 200'000;
    Outcome const outcome = run_all({talkative, quick("fine")}, 2, watch).front();
    CHECK(outcome.kind == Kind::failed);
    CHECK(outcome.output.size() < 300'000);
    talkative.most_output_bytes = 1'000'000;
    CHECK(run_all({talkative}, 1, watch).front().kind == Kind::done);
}

TEST_CASE("A hung, a crashed and a failed task do not stop the others") {
    SignalWatch const watch;
    std::vector<Task> const tasks{{hang, 0.2},
                                  quick("fine"),
                                  {crash, 30},
                                  {[]() -> std::string { throw std::runtime_error("no"); }, 30},
                                  {[]() -> std::string { _exit(3); }, 30},
                                  quick("too")};
    auto const outcomes = run_all(tasks, 2, watch);
    CHECK(outcomes[0].kind == Kind::timed_out);
    CHECK(outcomes[0].seconds >= 0.2);
    CHECK(outcomes[0].seconds < 10);
    CHECK(outcomes[1].output == "fine");
    CHECK(outcomes[2].kind == Kind::crashed);
    CHECK(outcomes[2].signal == SIGSEGV);
    CHECK(outcomes[3].kind == Kind::failed);
    CHECK(outcomes[4].exit_code == 3);
    CHECK(outcomes[5].output == "too");
}

TEST_CASE("A signal ends the tasks, and then the caller as it always does, whoever gets it first") {
    bool const task_is_first = GENERATE(false, true);
    for (int const signal : {SIGINT, SIGTERM}) {
        TempFolder const folder;
        pid_t const caller = start_caller(folder / "pid");
        pid_t const task = process_in(folder / "pid");
        CHECK(is_alive(task));
        if (task_is_first) {
            kill(task, signal);
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        kill(caller, signal);
        int status = 0;
        REQUIRE(waitpid(caller, &status, 0) == caller);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        CHECK(content_of(folder / "pid.interrupted") == "yes");
        CHECK_FALSE(is_alive(task));
    }
}

TEST_CASE("A caller that is killed leaves no task behind") {
    TempFolder const folder;
    pid_t const caller = start_caller(folder / "pid");
    pid_t const task = process_in(folder / "pid");
    kill(caller, SIGKILL);
    REQUIRE(waitpid(caller, nullptr, 0) == caller);
    // The orphan is somebody else's child now, who may take a while to bury it: a zombie counts as dead.
    CHECK(becomes_true([&] {
        std::string const status = content_of("/proc/" + std::to_string(task) + "/stat");
        std::size_t const name_end = status.rfind(')');
        return status.empty() || (name_end != std::string::npos && status.compare(name_end, 3, ") Z") == 0);
    }));
}

}  // namespace process_pool_test
