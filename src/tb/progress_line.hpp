#pragma once
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace faster {

/// What is done so far, on the terminal's last line; silent when stdout is no terminal.
class ProgressLine {
  public:
    /// `what`: plural noun of what is counted
    explicit ProgressLine(char const* what) : what_(what), visible_(isatty(STDOUT_FILENO) != 0) {}
    ProgressLine(ProgressLine const&) = delete;
    ProgressLine& operator=(ProgressLine const&) = delete;
    ~ProgressLine() {
        if (shown_) {
            fmt::print("\r\033[K");
            std::fflush(stdout);
        }
    }

    void show(std::uint64_t done, std::uint64_t all) {
        if (!visible_ || Clock::now() - last_ < std::chrono::milliseconds(100))
            return;
        last_ = Clock::now();
        shown_ = true;
        constexpr std::uint64_t width = 40;
        std::uint64_t const filled = done * width / all;
        fmt::print("\r[{:<{}}] {}/{} {}", std::string(filled, '#'), width, done, all, what_);
        std::fflush(stdout);
    }

  private:
    using Clock = std::chrono::steady_clock;

    char const* what_;
    bool visible_;
    bool shown_ = false;
    Clock::time_point last_ = Clock::now();
};

}  // namespace faster
