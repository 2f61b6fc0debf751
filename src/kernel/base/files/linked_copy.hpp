#pragma once
#include <filesystem>

namespace faster::io {

/// Makes `to`, which is not there, all that `from` is. Files become further names of the same file, or copies where the
/// file system has no such names. Throws std::filesystem::filesystem_error.
void copy_as_links(std::filesystem::path const& from, std::filesystem::path const& to);

}  // namespace faster::io
