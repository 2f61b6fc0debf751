#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fcntl.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "support/temp_folder.hpp"

using faster::test::TempFolder;

namespace {

struct Resources {
    int exit_code = -1;
    double seconds = 0;
    long peak_megabytes = 0;
};

/// Runs the tool without a shell, its output thrown away.
Resources resources_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), FASTER_SIM_BINARY);
    std::vector<char*> words(arguments.size() + 1, nullptr);
    std::transform(arguments.begin(), arguments.end(), words.begin(), [](std::string& word) { return word.data(); });
    auto const start = std::chrono::steady_clock::now();
    pid_t const child = fork();
    if (child == 0) {
        int const nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        execv(FASTER_SIM_BINARY, words.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    Resources resources;
    resources.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    resources.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    resources.peak_megabytes = usage.ru_maxrss / 1024;
    return resources;
}

#ifdef __SANITIZE_ADDRESS__
constexpr bool is_instrumented = true;  // by a sanitizer, whose memory and time are not ours
#else
constexpr bool is_instrumented = false;
#endif

}  // namespace

TEST_CASE("The tool starts in less than 0.2 seconds", "[resources]") {
    double fastest = 10;
    for (int i = 0; i < 5; ++i) {  // the machine may be busy with something else
        Resources const help = resources_of({"--help"});
        REQUIRE(help.exit_code == 0);
        fastest = std::min(fastest, help.seconds);
    }
    CHECK((is_instrumented || fastest < 0.2));
}

TEST_CASE("The main job needs less than 200 MB", "[resources]") {
    TempFolder const folder;
    Resources const run = resources_of(
        {"run", FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml", "--out", (folder.path() / "out").string()});
    REQUIRE(run.exit_code == 0);
    CAPTURE(run.peak_megabytes);
    CHECK((is_instrumented || run.peak_megabytes < 200));
}
