#include "tb/progress_line.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace faster {

ProgressLine::ProgressLine(char const* what) : what_(what), visible_(isatty(STDOUT_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
    if (shown_)
        fmt::print("\r\033[K");
}

void ProgressLine::show(std::uint64_t done, std::uint64_t all) {
    constexpr std::chrono::milliseconds between{100};
    if (!visible_ || HostClock::now() - last_ < between)
        return;
    last_ = HostClock::now();
    shown_ = true;
    constexpr std::uint64_t width = 40;
    std::uint64_t const filled = done * width / all;
    fmt::print("\r[{:<{}}] {}/{} {}", std::string(filled, '#'), width, done, all, what_);
    std::fflush(stdout);
}

}  // namespace faster
