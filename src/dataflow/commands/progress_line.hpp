#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "dataflow/base/counted_progress.hpp"
#include "dataflow/base/host_clock.hpp"

namespace dataflow {

/// What is done so far and how long the rest may take: on the terminal's last line, or, when stdout is no terminal, as
/// a line on stderr once a minute, so that logs of long work have it and short work is silent.
class ProgressLine {
  public:
    /// `already_done`: before this program started, so that it says nothing about the time left.
    explicit ProgressLine(char const* what, std::uint64_t already_done = 0,
                          std::chrono::milliseconds between_lines = std::chrono::minutes(1));
    ~ProgressLine();
    ProgressLine(ProgressLine const&) = delete;
    ProgressLine& operator=(ProgressLine const&) = delete;

    void show(std::uint64_t done, std::uint64_t all);
    /// Shows what it is told; must not outlive this.
    TellProgress teller() {
        return [this](std::size_t done, std::size_t all) { show(done, all); };
    }

  private:
    void show_on_terminal(std::uint64_t done, std::uint64_t all);
    std::string time_left(std::uint64_t done, std::uint64_t all) const;

    char const* what_;
    std::uint64_t already_done_;
    bool visible_;  ///< on a terminal
    std::chrono::milliseconds between_;
    bool shown_ = false;
    HostClock::time_point start_ = HostClock::now();
    HostClock::time_point last_ = start_;
};

}  // namespace dataflow
