#include "support/forked_bytes.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/longest_run.hpp"

namespace faster::testing {

namespace {

/// The test framework's handlers are taken off, or a crash would report the tests so far once more.
[[noreturn]] void run_child(int pipe, std::function<std::string()> const& work) {
    for (int const signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGTERM, SIGINT})
        std::signal(signal, SIG_DFL);
    alarm(test::longest_run_seconds);
    std::string const bytes = work();
    for (std::size_t done = 0; done < bytes.size();) {
        ssize_t const count = write(pipe, bytes.data() + done, bytes.size() - done);
        if (count < 0)
            _exit(EXIT_FAILURE);
        done += static_cast<std::size_t>(count);
    }
    _exit(EXIT_SUCCESS);
}

std::string read_all(int pipe) {
    std::string bytes;
    std::array<char, 65536> buffer{};
    for (;;) {
        ssize_t const count = read(pipe, buffer.data(), buffer.size());
        if (count > 0)
            bytes.append(buffer.data(), static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            return bytes;
    }
}

void check_status(int status) {
    if (WIFSIGNALED(status))
        throw std::runtime_error("forked_bytes: ended by signal " + std::to_string(WTERMSIG(status)));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS)
        throw std::runtime_error("forked_bytes: exit status " + std::to_string(WEXITSTATUS(status)));
}

}  // namespace

std::string forked_bytes(std::function<std::string()> const& work) {
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
        throw std::runtime_error("forked_bytes: no pipe");
    pid_t const child = fork();
    if (child < 0)
        throw std::runtime_error("forked_bytes: no process");
    if (child == 0) {
        close(ends[0]);
        run_child(ends[1], work);
    }
    close(ends[1]);
    std::string bytes = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    check_status(status);
    return bytes;
}

}  // namespace faster::testing
