#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace faster::test {

struct CommandResult {
    int exit_code = 0;
    std::string out;  ///< stdout
    std::string err;  ///< stderr
    double seconds = 0;
    long peak_megabytes = 0;
};

/// Runs a program in `folder`, without a shell, and waits for its end. Throws std::runtime_error if it cannot be
/// started, is ended by a signal or takes longer than two minutes.
CommandResult run_command(std::string const& program, std::vector<std::string> const& arguments,
                          std::filesystem::path const& folder);

/// Starts it, sends `signal` after a delay and waits for its end. Returns the signal that ended it, or 0. What it
/// prints is lost. `again_after_s`: then it is sent once more; 0: it is not. Throws std::runtime_error if a minute
/// later the program still goes on, and kills it.
int interrupted_command(std::string const& program, std::vector<std::string> const& arguments,
                        std::filesystem::path const& folder, double delay_s, int signal, double again_after_s = 0);

}  // namespace faster::test
