#include "dataflow/base/process_pool.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"

namespace dataflow::processes {

namespace {

/// Signals wait, for the thread that makes one and what it forks meanwhile: until a child has let them through, its
/// handlers would tell the parent.
class SignalsWait {
  public:
    SignalsWait() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before_);
    }
    ~SignalsWait() { end(); }
    SignalsWait(SignalsWait const&) = delete;
    SignalsWait& operator=(SignalsWait const&) = delete;

    void end() const { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

/// A child that writes its result into a pipe. The destructor ends and buries one that still runs.
class Child {
  public:
    Child(std::size_t number, Task const& task)
        : number_(number), time_limit_s_(task.time_limit_s), most_output_bytes_(task.most_output_bytes) {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0)
            throw HostError(std::string("no pipe for another process (") + std::strerror(errno) +
                            "), expected room for more open files");
        pid_t const parent = getpid();
        SignalsWait const wait;
        process_ = fork();
        if (process_ == 0) {
            close(ends[0]);
            run(task, parent, ends[1], wait);
        }
        close(ends[1]);
        pipe_ = ends[0];
        if (process_ < 0) {
            close(pipe_);
            throw HostError(std::string("no further process (") + std::strerror(errno) +
                            "), expected room for more processes");
        }
    }
    ~Child() {
        if (process_ > 0)
            end();
        close(pipe_);
    }
    Child(Child const&) = delete;
    Child& operator=(Child const&) = delete;

    std::size_t number() const { return number_; }
    int pipe_end() const { return pipe_; }
    double seconds_left() const { return time_limit_s_ - seconds_since(start_); }

    /// Takes what has come; true at the end.
    bool read_some() {
        std::array<char, 1U << 16U> buffer;
        ssize_t const count = read(pipe_, buffer.data(), buffer.size());
        if (count > 0)
            outcome_.output.append(buffer.data(), static_cast<std::size_t>(count));
        is_broken_ = count < 0 && errno != EINTR && errno != EAGAIN;
        return count == 0 || is_broken_;
    }

    Outcome finish() {
        if (is_broken_)
            return end_as(Outcome::Kind::failed);
        int const status = wait_for_end();
        if (WIFSIGNALED(status)) {
            outcome_.kind = Outcome::Kind::crashed;
            outcome_.signal = WTERMSIG(status);
        } else if (WEXITSTATUS(status) != EXIT_SUCCESS) {
            outcome_.kind = Outcome::Kind::failed;
            outcome_.exit_code = WEXITSTATUS(status);
        }
        return outcome_;
    }

    bool sends_too_much() const { return outcome_.output.size() > most_output_bytes_; }

    Outcome end_at_time_limit() { return end_as(Outcome::Kind::timed_out); }

    Outcome end_at_output_limit() {
        outcome_.exit_code = EXIT_FAILURE;
        return end_as(Outcome::Kind::failed);
    }

  private:
    Outcome end_as(Outcome::Kind kind) {
        end();
        outcome_.kind = kind;
        return outcome_;
    }

    /// It may have a file to take away that is half-written. If that takes long it is killed.
    void end() {
        constexpr int most_tries = 200;
        kill(process_, SIGTERM);
        for (int i = 0; i < most_tries && is_running(process_); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(process_, SIGKILL);
        wait_for_end();
    }

    [[noreturn]] static void run(Task const& task, pid_t parent, int pipe, SignalsWait const& wait) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
            _exit(EXIT_FAILURE);
        let_signals_through();
        wait.end();
        dup2(STDERR_FILENO, STDOUT_FILENO);  // what the work may print must not get into the parent's tables
        try {
            std::string const output = task.work();
            _exit(send(output, pipe) ? EXIT_SUCCESS : EXIT_FAILURE);
        } catch (...) {
            _exit(EXIT_FAILURE);
        }
    }

    static bool send(std::string const& bytes, int pipe) {
        for (std::size_t done = 0; done < bytes.size();) {
            ssize_t const count = write(pipe, bytes.data() + done, bytes.size() - done);
            if (count < 0 && errno != EINTR)
                return false;
            done += count > 0 ? static_cast<std::size_t>(count) : 0;
        }
        return true;
    }

    int wait_for_end() {
        int status = 0;
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        outcome_.seconds = seconds_since(start_);
        return status;
    }

    std::size_t number_;
    double time_limit_s_;
    std::uint64_t most_output_bytes_;
    HostClock::time_point start_ = HostClock::now();
    pid_t process_ = -1;
    int pipe_ = -1;
    bool is_broken_ = false;  // the pipe
    Outcome outcome_;
};

using Children = std::vector<std::unique_ptr<Child>>;

/// Until something happens or a time limit is reached. Which children have something to say.
std::vector<bool> wait_for_news(Children const& children, SignalWatch const& watch, double longest_wait_s) {
    std::vector<pollfd> polled{{watch.descriptor(), POLLIN, 0}};
    double shortest = longest_wait_s;
    for (auto const& child : children) {
        polled.push_back({child->pipe_end(), POLLIN, 0});
        shortest = std::min(shortest, std::max(0.0, child->seconds_left()));
    }
    int const ready = poll(polled.data(), polled.size(), static_cast<int>(std::ceil(shortest * 1000)));
    if (ready > 0 && polled.front().revents != 0)
        throw Interrupted();
    std::vector<bool> news;
    for (std::size_t i = 1; i < polled.size(); ++i)
        news.push_back(ready > 0 && polled[i].revents != 0);
    return news;
}

/// Throws Interrupted if a child ended because somebody wants all of the program to end, as Ctrl-C does: this process
/// gets the signal too, maybe a moment later.
void look_for_stop(Outcome const& outcome, SignalWatch const& watch) {
    constexpr int longest_moment_ms = 500;
    bool const stops = outcome.signal == SIGINT || outcome.signal == SIGTERM || outcome.signal == SIGHUP;
    if (outcome.kind != Outcome::Kind::crashed || !stops)
        return;
    pollfd polled{watch.descriptor(), POLLIN, 0};
    poll(&polled, 1, longest_moment_ms);  // the signal ends it, too
    if (poll(&polled, 1, 0) > 0)
        throw Interrupted();
}

using Ended = std::function<void(std::size_t, Outcome)>;

void collect(Children& children, std::vector<bool> const& news, SignalWatch const& watch, Ended const& ended) {
    std::vector<std::pair<std::size_t, Outcome>> outcomes;
    for (std::size_t i = 0; i < children.size(); ++i) {
        Child& child = *children[i];
        if (news[i] && child.read_some())
            outcomes.emplace_back(child.number(), child.finish());
        else if (child.sends_too_much())
            outcomes.emplace_back(child.number(), child.end_at_output_limit());
        else if (child.seconds_left() <= 0)
            outcomes.emplace_back(child.number(), child.end_at_time_limit());
        else
            continue;
        children[i].reset();
    }
    children.erase(std::remove(children.begin(), children.end(), nullptr), children.end());
    for (auto& [number, outcome] : outcomes) {
        look_for_stop(outcome, watch);
        ended(number, std::move(outcome));
    }
}

}  // namespace

bool is_running(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

void run_stream(TaskStream const& stream, std::size_t jobs, SignalWatch const& watch) {
    Children children;
    std::size_t next = 0;
    while (true) {
        while (children.size() < jobs_or_host_cores(jobs)) {
            std::optional<Task> const task = stream.next(next);
            if (!task)
                break;
            children.push_back(std::make_unique<Child>(next++, *task));
        }
        if (children.empty())
            return;
        collect(children, wait_for_news(children, watch, stream.meanwhile ? 0.2 : 3600), watch, stream.ended);
        if (stream.meanwhile)
            stream.meanwhile();
    }
}

std::vector<Outcome> run_all(std::vector<Task> const& tasks, std::size_t jobs, SignalWatch const& watch,
                             std::function<void(std::size_t, std::size_t)> const& progress) {
    std::vector<Outcome> outcomes(tasks.size());
    std::size_t done = 0;
    TaskStream stream;
    stream.next = [&](std::size_t number) {
        return number < tasks.size() ? std::optional<Task>(tasks[number]) : std::nullopt;
    };
    stream.ended = [&](std::size_t number, Outcome outcome) {
        outcomes[number] = std::move(outcome);
        ++done;
        if (progress)
            progress(done, tasks.size());
    };
    run_stream(stream, jobs, watch);
    return outcomes;
}

}  // namespace dataflow::processes
