#pragma once
#include <filesystem>
#include <string>

#include "dataflow/base/input_error.hpp"

namespace dataflow::io {

/// Throws InputError "<path>: <what>", which is how every complaint about a file reads.
[[noreturn]] inline void fail(std::filesystem::path const& path, std::string const& what) {
    throw InputError(path.string() + ": " + what);
}

/// Throws HostError "<path>: cannot be written (<why>)".
[[noreturn]] inline void fail_to_write(std::filesystem::path const& path, std::string const& why) {
    throw HostError(path.string() + ": cannot be written (" + why + ")");
}

}  // namespace dataflow::io
