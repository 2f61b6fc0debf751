#include "support/explore_process.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/argument_words.hpp"

namespace faster::test {

namespace {

/// The first line, once it is whole.
std::string first_line(std::filesystem::path const& file) {
    std::string const text = content_of(file);
    std::size_t const end = text.find('\n');
    return end == std::string::npos ? "" : text.substr(0, end);
}

}  // namespace

ExploreProcess::ExploreProcess(std::string const& tool, std::vector<std::string> arguments,
                               std::filesystem::path const& folder) {
    arguments.insert(arguments.begin(), "explore");
    ArgumentWords const words(tool, arguments);
    std::string const out = output_ / "stdout";
    process_ = fork();
    if (process_ == 0) {
        constexpr unsigned longest_life_s = 280;
        std::signal(SIGINT, SIG_DFL);
        alarm(longest_life_s);
        int const file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (file >= 0 && dup2(file, STDOUT_FILENO) >= 0 && chdir(folder.c_str()) == 0)
            execv(tool.c_str(), words.pointers());
        _exit(127);
    }
    for (int tries = 0; tries < 6000 && address_.empty(); ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        address_ = first_line(out);
    }
    if (address_.rfind("http://127.0.0.1:", 0) != 0)
        throw std::runtime_error("explore printed no address but '" + address_ + "'");
}

ExploreProcess::~ExploreProcess() { interrupt(); }

int ExploreProcess::port() const { return std::stoi(address_.substr(std::string("http://127.0.0.1:").size())); }

std::string ExploreProcess::home() const { return address_.substr(address_.find('/', std::string("http://").size())); }

int ExploreProcess::interrupt() {
    if (process_ < 0)
        return -1;
    kill(process_, SIGINT);
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace faster::test
