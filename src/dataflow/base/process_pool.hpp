#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "dataflow/base/signal_watch.hpp"

namespace dataflow::processes {

/// Whether a child has not ended. One that has stays until it is waited for, so its number is not another's.
bool is_running(pid_t child);

/// Work for a process of its own: what it returns is sent back. Exceptions end the process with exit code 1.
struct Task {
    std::function<std::string()> work;
    double time_limit_s = 3600;  ///< from the start of its process on
    /// Of what is sent back. A process that sends more is killed, and has failed.
    std::uint64_t most_output_bytes = std::numeric_limits<std::uint64_t>::max();
};

/// How a task ended.
struct Outcome {
    enum class Kind {
        done,       ///< `output` is what it returned
        timed_out,  ///< killed at its time limit
        crashed,    ///< ended by `signal`
        failed,     ///< ended with exit code `exit_code`, other than 0
    };
    Kind kind = Kind::done;
    std::string output;
    int signal = 0;
    int exit_code = 0;
    double seconds = 0;  ///< of the host
};

/// Tasks that depend on how others ended, for run_stream().
struct TaskStream {
    /// The task of that number (0, 1, 2, ...); none if there is none now. Then it is asked again when another has
    /// ended.
    std::function<std::optional<Task>(std::size_t number)> next;
    /// That task has ended. May throw, which ends all others.
    std::function<void(std::size_t number, Outcome outcome)> ended;
    /// Called several times a second; may be empty.
    std::function<void()> meanwhile = {};
};

/// As run_all(), until there is no task left and none runs.
void run_stream(TaskStream const& stream, std::size_t jobs, SignalWatch const& watch);

/// Runs every task in a forked process, at most `jobs` at once (0: as many as the host has cores), and returns the
/// outcomes in the order of the tasks. A task that hangs or crashes does not disturb the others. No process outlives
/// the call, nor the caller if that is killed. Throws Interrupted when `watch` sees a signal. `progress` is told now
/// and then how many are done. Call it while the program has one thread only.
std::vector<Outcome> run_all(std::vector<Task> const& tasks, std::size_t jobs, SignalWatch const& watch,
                             std::function<void(std::size_t done, std::size_t all)> const& progress = {});

}  // namespace dataflow::processes
