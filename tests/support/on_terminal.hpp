#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace faster::test {

/// What a program prints when its stdout is a terminal of 100 columns and 30 lines, line ends as the program wrote
/// them. `environment`: NAME=VALUE, on top of ours. Throws std::runtime_error if it cannot be started or fails.
std::string output_on_terminal(std::string const& program, std::vector<std::string> const& arguments,
                               std::vector<std::string> const& environment);

}  // namespace faster::test
