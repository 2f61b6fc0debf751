#include "dataflow/base/program_output.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "dataflow/base/files/c_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"

namespace dataflow {

namespace {

bool write_all(std::string const& text, std::FILE* file) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0 &&
           std::fseek(file, 0, SEEK_SET) == 0;
}

std::string read_all(std::FILE* file) {
    std::string text;
    std::fseek(file, 0, SEEK_SET);
    char buffer[4096];
    for (std::size_t read = 0; (read = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        text.append(buffer, read);
    if (std::ferror(file) != 0)
        throw HostError("temporary file: cannot read what another program wrote, expected a file that can be read");
    return text;
}

[[noreturn]] void fail(std::string const& program, std::string const& what) {
    throw HostError(fmt::format("{}: {}, expected a program that works", program, what));
}

void kill_once_unwanted(pid_t process, std::function<bool()> const& is_wanted) {
    while (processes::is_running(process) && is_wanted())
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(process, SIGKILL);
}

/// False if there is no such program.
bool run(std::vector<std::string>& words, std::FILE* input, std::FILE* output, std::function<bool()> const& is_wanted) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, fileno(input), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(output), STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    int const error = posix_spawnp(&process, arguments.front(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error == ENOENT || error == EACCES || error == ENOTDIR)
        return false;
    if (error != 0)
        fail(words.front(), fmt::format("cannot be started ({})", std::strerror(error)));
    if (is_wanted)
        kill_once_unwanted(process, is_wanted);
    int status = 0;
    if (waitpid(process, &status, 0) != process)
        fail(words.front(), "cannot be waited for");
    if (WIFSIGNALED(status))
        fail(words.front(), "was killed");
    if (WEXITSTATUS(status) != 0)
        fail(words.front(), fmt::format("failed (exit code {})", WEXITSTATUS(status)));
    return true;
}

}  // namespace

std::optional<std::string> program_output(std::vector<std::string> words, std::string const& input,
                                          std::function<bool()> const& is_wanted) {
    // Instead of pipes: nobody has to read while somebody writes, and nobody is told by a signal that the other is
    // gone.
    io::CFile const in(std::tmpfile());
    io::CFile const out(std::tmpfile());
    if (!in || !out || !write_all(input, in.get()))
        throw HostError(fmt::format("temporary file: cannot be written for {} ({}), expected room for it",
                                    words.front(), std::strerror(errno)));
    return run(words, in.get(), out.get(), is_wanted) ? std::optional(read_all(out.get())) : std::nullopt;
}

}  // namespace dataflow
