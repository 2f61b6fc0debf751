#pragma once
#include <optional>
#include <string>
#include <vector>

namespace dataflow {

/// One thing wrong with a configuration file or a --set.
struct KeyFault {
    int line = 0;                      ///< in the file, from 1
    std::string key;                   ///< dotted
    std::optional<std::string> found;  ///< the value, if that is what is wrong
    std::string problem;               ///< "expected an integer from 1 to 4096"

    /// "KEY = VALUE, expected ..." or "KEY: unknown key ..."
    std::string text() const { return found ? key + " = " + *found + ", " + problem : key + ": " + problem; }
};
using KeyFaults = std::vector<KeyFault>;

/// Throws the InputError for a list of messages, if there are any: the first, and how many more.
void throw_first(std::vector<std::string> const& messages);

}  // namespace dataflow
