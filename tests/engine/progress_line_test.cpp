#include "dataflow/commands/progress_line.hpp"

#include <catch2/catch.hpp>
#include <cstdio>
#include <fcntl.h>
#include <functional>
#include <string>
#include <thread>
#include <unistd.h>

#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace progress_line_test {

using faster::ProgressLine;
using namespace faster::test;

/// What `work` writes to stderr while stdout is no terminal.
std::string said_by(std::function<void()> const& work) {
    TempFolder const folder;
    int const out = dup(STDOUT_FILENO), err = dup(STDERR_FILENO);
    int const file = open((folder / "err").c_str(), O_WRONLY | O_CREAT, 0600);
    int const null = open("/dev/null", O_WRONLY);
    std::fflush(stdout);
    dup2(null, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    work();
    std::fflush(stderr);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    for (int const each : {out, err, file, null})
        close(each);
    return content_of(folder / "err");
}

TEST_CASE("Where stdout is no terminal, progress is a line on stderr now and then", "[progress]") {
    std::string const said = said_by([] {
        ProgressLine progress("points", 10, std::chrono::milliseconds(100));
        progress.show(20, 100);  // too early
        std::this_thread::sleep_for(std::chrono::milliseconds(120));
        progress.show(50, 100);
        progress.show(51, 100);
    });
    CHECK_THAT(said, Catch::Contains(": 50 of 100 points, ") && Catch::Contains(" left\n"));
    CHECK(said.find('\n') + 1 == said.size());
}

TEST_CASE("Work of less than a minute says nothing in a log", "[progress]") {
    CHECK(said_by([] {
              ProgressLine progress("points");
              for (std::uint64_t i = 0; i <= 100; ++i)
                  progress.show(i, 100);
          }).empty());
}

}  // namespace progress_line_test
