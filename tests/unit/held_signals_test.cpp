// Signals that would end the program, while something is half-written: whatever thread writes, and whoever asks twice.
#include "dataflow/base/held_signals.hpp"

#include <catch2/catch.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <functional>
#include <initializer_list>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/signal_watch.hpp"
#include "dataflow/tools/recording/fst_file.hpp"
#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace held_signals_test {

using namespace dataflow::processes;
using faster::test::TempFolder;
namespace fs = std::filesystem;

constexpr std::chrono::milliseconds step{10};

void sleep_for(std::chrono::milliseconds time) { std::this_thread::sleep_for(time); }

/// A process that does `work`, which says by making the file that it has begun.
class Process {
  public:
    explicit Process(std::function<void(fs::path const& begun)> const& work) : process_(fork()) {
        if (process_ == 0) {
            for (int const signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
                std::signal(signal, SIG_DFL);  // not the test framework's report
            alarm(30);
            work(folder_ / "begun");
            _exit(0);
        }
        while (!fs::exists(folder_ / "begun"))
            sleep_for(step);
    }
    ~Process() {
        if (!ended_) {
            kill(process_, SIGKILL);
            waitpid(process_, nullptr, 0);
        }
    }
    Process(Process const&) = delete;
    Process& operator=(Process const&) = delete;

    void send(int signal) const { kill(process_, signal); }
    /// Which signal ended it within that time: 0 if it ended by itself, -1 if it goes on.
    int ended_by(std::chrono::milliseconds within) {
        int status = 0;
        for (auto waited = step; !ended_ && waited <= within; waited += step) {
            sleep_for(step);
            ended_ = waitpid(process_, &status, WNOHANG) == process_;
        }
        if (!ended_)
            return -1;
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }

  private:
    TempFolder folder_;
    pid_t process_;
    bool ended_ = false;
};

void say(fs::path const& begun) { std::ofstream(begun) << "yes"; }

[[noreturn]] void sleep_for_ever() {
    for (;;)
        sleep_for(step);
}

TEST_CASE("A signal ends a program whose threads hold signals back by turns", "[signals]") {
    for (int const signal : {SIGINT, SIGTERM, SIGHUP}) {
        Process process([](fs::path const& begun) {
            say(begun);
            try {
                faster::on_threads(1'000'000'000, 3, [](std::size_t i) {
                    if (i % 3 == 0)
                        return sleep_for(std::chrono::milliseconds(1));
                    HeldSignals const held;
                    sleep_for(std::chrono::milliseconds(1));
                    give_up_if_interrupted();
                });
            } catch (Interrupted const&) {
            }
        });
        process.send(signal);
        CHECK(process.ended_by(std::chrono::seconds(5)) == signal);
    }
}

TEST_CASE("A signal is held back in whatever thread, and lets what is half-written be taken away", "[signals]") {
    TempFolder const folder;
    folder.write("half", "");
    Process process([&](fs::path const& begun) {
        std::thread writer([&] {
            HeldSignals const held;
            say(begun);
            try {
                for (;;) {
                    sleep_for(step);
                    give_up_if_interrupted();
                }
            } catch (Interrupted const&) {
                fs::remove(folder / "half");
            }
        });
        writer.join();
    });
    process.send(SIGTERM);
    CHECK(process.ended_by(std::chrono::seconds(5)) == SIGTERM);
    CHECK_FALSE(fs::exists(folder / "half"));
}

TEST_CASE("An FST that takes long is given up at once, and leaves nothing", "[signals]") {
    TempFolder const folder;
    Process process([&](fs::path const& begun) {
        try {
            dataflow::recording::FstFile file(folder / "w.fst", 100);
            file.declare({"a", 1, {}});
            say(begun);
            for (std::uint64_t ticks = 0;; ++ticks)
                file.go_to(ticks);
        } catch (Interrupted const&) {
        }
    });
    process.send(SIGTERM);
    CHECK(process.ended_by(std::chrono::seconds(5)) == SIGTERM);
    CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("A second signal ends at once who does not look at the first", "[signals]") {
    for (int const second : {SIGINT, SIGTERM}) {
        Process process([](fs::path const& begun) {
            HeldSignals const held;
            say(begun);
            sleep_for_ever();
        });
        process.send(SIGINT);
        process.send(SIGINT);  // the same wish, told twice
        CHECK(process.ended_by(std::chrono::milliseconds(400)) == -1);
        process.send(second);
        CHECK(process.ended_by(std::chrono::seconds(2)) == second);
    }
}

TEST_CASE("A second signal also ends who has taken the first as done with", "[signals]") {
    Process process([](fs::path const& begun) {
        SignalWatch const watch;
        say(begun);
        while (kill(getpid(), 0) == 0) {
            sleep_for(step);
            watch.take();
        }
    });
    process.send(SIGTERM);
    CHECK(process.ended_by(std::chrono::milliseconds(400)) == -1);
    process.send(SIGTERM);
    CHECK(process.ended_by(std::chrono::seconds(2)) == SIGTERM);
}

TEST_CASE("A signal that came while none was held back any more does not count for the next one", "[signals]") {
    Process process([](fs::path const& begun) {
        std::signal(SIGTERM, [](int) {});  // as a caller may have it
        { HeldSignals const held; }
        say(begun);
        sleep_for(std::chrono::milliseconds(500));
        {
            HeldSignals const held;
            sleep_for(std::chrono::milliseconds(100));
            give_up_if_interrupted();
        }
    });
    process.send(SIGTERM);
    CHECK(process.ended_by(std::chrono::seconds(5)) == 0);
}

TEST_CASE("Who lets signals through leaves the error of the system that is yet to be told", "[signals]") {
    SignalWatch const watch;  // has a descriptor, with nothing to be read
    errno = ENOSPC;
    watch.take();
    CHECK(errno == ENOSPC);
    TempFolder const folder;
    Process process([&](fs::path const& begun) {
        { SignalWatch const first; }
        errno = ENOSPC;
        { HeldSignals const held; }
        folder.write(errno == ENOSPC ? "kept" : "lost", "");
        say(begun);
    });
    CHECK(process.ended_by(std::chrono::seconds(5)) == 0);
    CHECK(fs::exists(folder / "kept"));
}

TEST_CASE("Signals that the caller ignores stay ignored", "[signals]") {
    Process process([](fs::path const& begun) {
        std::signal(SIGHUP, SIG_IGN);
        HeldSignals const held;
        say(begun);
        sleep_for(std::chrono::milliseconds(300));
        give_up_if_interrupted();
    });
    process.send(SIGHUP);
    CHECK(process.ended_by(std::chrono::seconds(5)) == 0);
}

}  // namespace held_signals_test
