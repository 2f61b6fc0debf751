#include "kernel/base/program_output.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "kernel/base/files/c_file.hpp"
#include "kernel/base/input_error.hpp"

namespace faster {

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

/// Whether it ran, and ended well.
bool run(std::vector<std::string>& words, std::FILE* input, std::FILE* output) {
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
    int status = 0;
    if (error != 0 || waitpid(process, &status, 0) != process)
        return false;
    if (WIFSIGNALED(status))
        throw HostError(words.front() + ": was killed, expected a program that ends by itself");
    return WEXITSTATUS(status) == 0;
}

}  // namespace

std::optional<std::string> program_output(std::vector<std::string> words, std::string const& input) {
    // Instead of pipes: nobody has to read while somebody writes, and nobody is told by a signal that the other is
    // gone.
    io::CFile const in(std::tmpfile());
    io::CFile const out(std::tmpfile());
    if (!in || !out || !write_all(input, in.get()) || !run(words, in.get(), out.get()))
        return std::nullopt;
    return read_all(out.get());
}

}  // namespace faster
