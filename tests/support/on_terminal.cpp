#include "support/on_terminal.hpp"

#include <cstdlib>
#include <pty.h>
#include <stdexcept>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/argument_words.hpp"
#include "support/longest_run.hpp"

namespace faster::test {

namespace {

/// A terminal turns "\n" into "\r\n" unless told otherwise.
termios without_output_processing() {
    termios settings{};
    settings.c_cflag = CS8 | CREAD;
    return settings;
}

[[noreturn]] void become(char* const* words, std::vector<std::string> const& environment) {
    alarm(longest_run_seconds);
    for (std::string const& variable : environment)
        putenv(const_cast<char*>(variable.c_str()));
    execv(words[0], words);
    _exit(127);
}

/// Reading from a terminal fails once no program has it open any more.
std::string read_all(int terminal) {
    std::string text;
    char buffer[4096];
    for (ssize_t count = 0; (count = read(terminal, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(count));
    close(terminal);
    return text;
}

}  // namespace

std::string output_on_terminal(std::string const& program, std::vector<std::string> const& arguments,
                               std::vector<std::string> const& environment) {
    ArgumentWords const words(program, arguments);
    termios const settings = without_output_processing();
    winsize const size{30, 100, 0, 0};
    int terminal = -1;
    pid_t const child = forkpty(&terminal, nullptr, &settings, &size);
    if (child < 0)
        throw std::runtime_error(program + ": no process on a terminal");
    if (child == 0)
        become(words.pointers(), environment);
    std::string text = read_all(terminal);
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw std::runtime_error(program + ": failed\n" + text);
    return text;
}

}  // namespace faster::test
