#pragma once
#include <chrono>
#include <cstdint>

namespace faster {

/// What is done so far, on the terminal's last line; silent when stdout is no terminal.
class ProgressLine {
  public:
    explicit ProgressLine(char const* what);
    ~ProgressLine();
    ProgressLine(ProgressLine const&) = delete;
    ProgressLine& operator=(ProgressLine const&) = delete;

    void show(std::uint64_t done, std::uint64_t all);

  private:
    using HostClock = std::chrono::steady_clock;

    char const* what_;
    bool visible_;
    bool shown_ = false;
    HostClock::time_point last_ = HostClock::now();
};

}  // namespace faster
