#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace dataflow {

/// What is done so far and how long the rest may take, on the terminal's last line; silent when stdout is no terminal.
class ProgressLine {
  public:
    /// `already_done`: before this program started, so that it says nothing about the time left.
    explicit ProgressLine(char const* what, std::uint64_t already_done = 0);
    ~ProgressLine();
    ProgressLine(ProgressLine const&) = delete;
    ProgressLine& operator=(ProgressLine const&) = delete;

    void show(std::uint64_t done, std::uint64_t all);

  private:
    using HostClock = std::chrono::steady_clock;

    std::string time_left(std::uint64_t done, std::uint64_t all) const;

    char const* what_;
    std::uint64_t already_done_;
    bool visible_;
    bool shown_ = false;
    HostClock::time_point start_ = HostClock::now();
    HostClock::time_point last_ = HostClock::now();
};

}  // namespace dataflow
