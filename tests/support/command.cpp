#include "support/command.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/argument_words.hpp"
#include "support/longest_run.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

namespace {

constexpr int cannot_start = 127;

bool redirect(int descriptor, char const* file) {
    int const opened = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    return opened >= 0 && dup2(opened, descriptor) >= 0;
}

/// Never returns, and allocates nothing. The alarm and default handlers survive exec.
[[noreturn]] void become(char* const* words, char const* folder, char const* out, char const* err, sigset_t mask) {
    for (int const signal : {SIGTERM, SIGINT, SIGALRM, SIGHUP, SIGPIPE})
        std::signal(signal, SIG_DFL);
    sigprocmask(SIG_SETMASK, &mask, nullptr);
    alarm(longest_run_seconds);
    if (redirect(STDOUT_FILENO, out) && redirect(STDERR_FILENO, err) && chdir(folder) == 0)
        execv(words[0], words);
    _exit(cannot_start);
}

pid_t start(ArgumentWords const& words, std::filesystem::path const& folder, std::string const& out,
            std::string const& err) {
    sigset_t all, before;  // a signal that comes early is not for the test framework's handlers
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before);
    pid_t const child = fork();
    if (child == 0)
        become(words.pointers(), folder.c_str(), out.c_str(), err.c_str(), before);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    if (child < 0)
        throw std::runtime_error(std::string(words.pointers()[0]) + ": no process");
    return child;
}

bool ends_within_a_minute(pid_t child, int& status) {
    auto const end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (waitpid(child, &status, WNOHANG) != child) {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

}  // namespace

CommandResult run_command(std::string const& program, std::vector<std::string> const& arguments,
                          std::filesystem::path const& folder) {
    // Files rather than pipes: a program that fills one pipe while the other is read would block.
    TempFolder const captured;
    std::string const out = captured / "stdout", err = captured / "stderr";
    auto const start_time = std::chrono::steady_clock::now();
    pid_t const child = start(ArgumentWords(program, arguments), folder, out, err);
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0) {
        if (errno != EINTR)
            throw std::runtime_error(program + ": cannot be waited for");
    }
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_time).count();
    if (WIFSIGNALED(status))
        throw std::runtime_error(program + ": ended by signal " + std::to_string(WTERMSIG(status)) + "\n" +
                                 content_of(err));
    if (WEXITSTATUS(status) == cannot_start)
        throw std::runtime_error(program + ": cannot be started");
    return {WEXITSTATUS(status), content_of(out), content_of(err), seconds, usage.ru_maxrss / 1024};
}

int interrupted_command(std::string const& program, std::vector<std::string> const& arguments,
                        std::filesystem::path const& folder, double delay_s, int signal, double again_after_s) {
    pid_t const child = start(ArgumentWords(program, arguments), folder, "/dev/null", "/dev/null");
    std::this_thread::sleep_for(std::chrono::duration<double>(delay_s));
    kill(child, signal);
    if (again_after_s > 0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(again_after_s));
        kill(child, signal);
    }
    int status = 0;
    if (!ends_within_a_minute(child, status)) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        throw std::runtime_error(arguments.front() + ": goes on a minute after signal " + std::to_string(signal));
    }
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace faster::test
