#include "support/command.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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
[[noreturn]] void become(char* const* words, char const* folder, char const* out, char const* err) {
    for (int const signal : {SIGTERM, SIGINT, SIGALRM})
        std::signal(signal, SIG_DFL);
    alarm(longest_run_seconds);
    if (redirect(STDOUT_FILENO, out) && redirect(STDERR_FILENO, err) && chdir(folder) == 0)
        execv(words[0], words);
    _exit(cannot_start);
}

}  // namespace

CommandResult run_command(std::string const& program, std::vector<std::string> const& arguments,
                          std::filesystem::path const& folder) {
    // Files rather than pipes: a program that fills one pipe while the other is read would block.
    TempFolder const captured;
    std::string const out = captured / "stdout", err = captured / "stderr";
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);

    auto const start = std::chrono::steady_clock::now();
    pid_t const child = fork();
    if (child < 0)
        throw std::runtime_error(program + ": no process");
    if (child == 0)
        become(pointers.data(), folder.c_str(), out.c_str(), err.c_str());
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0) {
        if (errno != EINTR)
            throw std::runtime_error(program + ": cannot be waited for");
    }
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (WIFSIGNALED(status))
        throw std::runtime_error(program + ": ended by signal " + std::to_string(WTERMSIG(status)) + "\n" +
                                 content_of(err));
    if (WEXITSTATUS(status) == cannot_start)
        throw std::runtime_error(program + ": cannot be started");
    return {WEXITSTATUS(status), content_of(out), content_of(err), seconds, usage.ru_maxrss / 1024};
}

}  // namespace faster::test
