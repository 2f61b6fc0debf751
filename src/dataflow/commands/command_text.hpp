#pragma once
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): as the library has it
class App;
}

namespace dataflow {

/// What a command was asked for, as it can be typed in a shell again: its name, operands, and options in the order of
/// --help. Options that change no byte of any output are left out: where outputs go, and how the host gets there.
std::string command_text(CLI::App const& command);

}  // namespace dataflow
