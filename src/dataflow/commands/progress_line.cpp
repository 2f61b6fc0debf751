#include "dataflow/commands/progress_line.hpp"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

#include "dataflow/base/program_name.hpp"
#include "dataflow/commands/say.hpp"

namespace dataflow {

namespace {

std::string duration_text(std::uint64_t seconds) {
    constexpr std::uint64_t minute = 60, hour = 3600;
    if (seconds >= hour)
        return fmt::format("{} h {} min", seconds / hour, seconds % hour / minute);
    if (seconds >= minute)
        return fmt::format("{} min {} s", seconds / minute, seconds % minute);
    return fmt::format("{} s", seconds);
}

}  // namespace

ProgressLine::ProgressLine(char const* what, std::uint64_t already_done, std::chrono::milliseconds between_lines)
    : what_(what),
      already_done_(already_done),
      visible_(isatty(STDOUT_FILENO) != 0),
      between_(visible_ ? std::chrono::milliseconds(100) : between_lines) {}

ProgressLine::~ProgressLine() {
    if (shown_)
        fmt::print("\r\033[K");
}

void ProgressLine::show(std::uint64_t done, std::uint64_t all) {
    if (HostClock::now() - last_ < between_)
        return;
    last_ = HostClock::now();
    if (visible_)
        show_on_terminal(done, all);
    else
        warn("{}: {} of {} {}{}\n", program_name(), done, all, what_, time_left(done, all));
}

void ProgressLine::show_on_terminal(std::uint64_t done, std::uint64_t all) {
    shown_ = true;
    constexpr std::uint64_t width = 40;
    std::uint64_t const filled = done * width / all;
    fmt::print("\r[{:<{}}] {}/{} {}{}\033[K", std::string(filled, '#'), width, done, all, what_, time_left(done, all));
    std::fflush(stdout);
}

/// As if the rest took as long as what is done, one like the other.
std::string ProgressLine::time_left(std::uint64_t done, std::uint64_t all) const {
    if (done <= already_done_ || done >= all)
        return "";
    double const seconds = std::chrono::duration<double>(HostClock::now() - start_).count();
    double const left = seconds / static_cast<double>(done - already_done_) * static_cast<double>(all - done);
    return ", " + duration_text(static_cast<std::uint64_t>(std::llround(left))) + " left";
}

}  // namespace dataflow
