#pragma once
#include <string>
#include <vector>

#include "dataflow/commands/subcommand.hpp"

namespace dataflow {

/// What a tool says of itself.
struct ToolText {
    std::string name;         ///< as it is called, e.g. faster-sim
    std::string description;  ///< one line
    std::string version;
    std::string commit = {};       ///< of its sources, if that is known
    std::string commit_date = {};  ///< yyyy-mm-dd
};

/// Reads a command line, does what it says, and returns the exit code. Errors are one line each. For sc_main().
int run_tool(ToolText const& text, std::vector<Subcommand> const& commands, int argc, char** argv);

}  // namespace dataflow
