#pragma once
#include <functional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): as the library has it
class App;
}

namespace dataflow {

/// A subcommand of a tool. `declare` adds its options to the parser and returns what it does once they have been read:
/// a function that returns the exit code, and throws InputError on bad input.
struct Subcommand {
    std::string name;
    std::string help;  ///< one line
    std::function<std::function<int()>(CLI::App& options)> declare;
};

}  // namespace dataflow
